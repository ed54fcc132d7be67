// Light or dark: what the system says, unless the reader has chosen. Runs before anything is drawn.
const theme = (() => {
  const system = matchMedia('(prefers-color-scheme: dark)');
  const listeners = [];
  let choice = 'system';
  try {
    choice = localStorage.getItem('mapwright-theme') ?? 'system';
  } catch {
    // A page opened from a file may have no storage.
  }

  function apply() {
    const dark = choice === 'dark' || (choice !== 'light' && system.matches);
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    for (const listener of listeners) listener();
  }

  function choose(name) {
    choice = name;
    try {
      localStorage.setItem('mapwright-theme', name);
    } catch {
      // Then the choice lasts as long as the page.
    }
    apply();
  }

  system.addEventListener('change', apply);
  apply();
  return { choose, choice: () => choice, onChange: (listener) => listeners.push(listener) };
})();
