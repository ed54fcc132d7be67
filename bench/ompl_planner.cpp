#include "bench/ompl_planner.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <memory>
#include <mutex>
#include <utility>

namespace mapwright::bench {
namespace {

namespace ob = ompl::base;
using navcore::FreeSpace;
using navcore::PlanningResult;
using navcore::PlanQuery;
using State = ob::RealVectorStateSpace::StateType;

constexpr double kTimeLimit_s = 10.0;
constexpr double kStep_m = 0.1;

Point point_of(const ob::State* state) {
  const auto* values = state->as<State>();
  return {(*values)[0], (*values)[1]};
}

class ExactMotion : public ob::MotionValidator {
 public:
  ExactMotion(const ob::SpaceInformationPtr& information, const FreeSpace& space, double radius_m)
      : ob::MotionValidator(information), space_(space), radius_m_(radius_m) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const Point a = point_of(from);
    const Point b = point_of(to);
    return space_.is_free(b, radius_m_) && space_.is_free_way(a, b, radius_m_);
  }
  // RRTConnect asks for no more than the answer.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>&) const override {
    return checkMotion(from, to);
  }

 private:
  const FreeSpace& space_;
  double radius_m_;
};

ob::SpaceInformationPtr make_information(const FreeSpace& space, double radius_m) {
  const Border& border = space.border();
  auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0, border.left);
  bounds.setHigh(0, border.right);
  bounds.setLow(1, border.bottom);
  bounds.setHigh(1, border.top);
  plane->setBounds(bounds);
  auto information = std::make_shared<ob::SpaceInformation>(plane);
  information->setStateValidityChecker([&space, radius_m](const ob::State* state) {
    return space.is_free(point_of(state), radius_m);
  });
  return information;
}

ob::ProblemDefinitionPtr make_problem(const ob::SpaceInformationPtr& information,
                                      const PlanQuery& query) {
  ob::ScopedState<ob::RealVectorStateSpace> start(information);
  ob::ScopedState<ob::RealVectorStateSpace> goal(information);
  start[0] = query.start.x;
  start[1] = query.start.y;
  goal[0] = query.goal.x;
  goal[1] = query.goal.y;
  auto problem = std::make_shared<ob::ProblemDefinition>(information);
  problem->setStartAndGoalStates(start, goal);
  return problem;
}

// OMPL's generators are seeded once in a process; more it does not offer.
void quiet_and_repeatable() {
  static std::once_flag done;
  std::call_once(done, [] {
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(1);
  });
}

PlanningResult solve(const ob::SpaceInformationPtr& information, const PlanQuery& query) {
  quiet_and_repeatable();
  information->setup();
  const auto problem = make_problem(information, query);
  ompl::geometric::RRTConnect planner(information);
  planner.setProblemDefinition(problem);
  planner.setup();
  PlanningResult result;
  const auto status = planner.solve(ob::timedPlannerTerminationCondition(kTimeLimit_s));
  if (status != ob::PlannerStatus::EXACT_SOLUTION) return result;
  result.solved = true;
  const auto* path = problem->getSolutionPath()->as<ompl::geometric::PathGeometric>();
  for (std::size_t i = 0; i < path->getStateCount(); ++i) {
    result.path.push_back(point_of(path->getState(static_cast<unsigned>(i))));
  }
  return result;
}

}  // namespace

bool has_ompl() {
  return true;
}

PlanningResult plan_with_ompl_exactly(const FreeSpace& space, const PlanQuery& query, Random&) {
  const auto information = make_information(space, query.radius_m);
  information->setMotionValidator(
      std::make_shared<ExactMotion>(information, space, query.radius_m));
  return solve(information, query);
}

PlanningResult plan_with_ompl_in_steps(const FreeSpace& space, const PlanQuery& query, Random&) {
  const auto information = make_information(space, query.radius_m);
  information->setStateValidityCheckingResolution(kStep_m / information->getMaximumExtent());
  return solve(information, query);
}

}  // namespace mapwright::bench
