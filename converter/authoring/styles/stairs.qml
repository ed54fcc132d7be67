<!DOCTYPE qgis PUBLIC "http://mrcc.com/qgis.dtd" "SYSTEM">
<qgis version="3.22.0" styleCategories="Symbology|Labeling|Fields|Forms" labelsEnabled="1">
  <renderer-v2 type="singleSymbol" symbollevels="0" enableorderby="0" forceraster="0">
    <symbols>
      <symbol name="0" type="fill" alpha="1" clip_to_extent="1" force_rhr="0">
        <layer class="SimpleFill" enabled="1" pass="0" locked="0">
          <Option type="Map">
            <Option name="color" type="QString" value="250,221,140,255"/>
            <Option name="style" type="QString" value="solid"/>
            <Option name="outline_color" type="QString" value="150,110,20,255"/>
            <Option name="outline_width" type="QString" value="0.3"/>
            <Option name="outline_style" type="QString" value="solid"/>
            <Option name="outline_width_unit" type="QString" value="MM"/>
            <Option name="joinstyle" type="QString" value="miter"/>
          </Option>
        </layer>
        <layer class="CentroidFill" enabled="1" pass="0" locked="0">
          <Option type="Map">
            <Option name="point_on_surface" type="QString" value="1"/>
            <Option name="point_on_all_parts" type="QString" value="0"/>
          </Option>
          <symbol name="@0@1" type="marker" alpha="1" clip_to_extent="1" force_rhr="0">
            <layer class="SimpleMarker" enabled="1" pass="0" locked="0">
              <Option type="Map">
                <Option name="name" type="QString" value="arrow"/>
                <Option name="color" type="QString" value="150,110,20,255"/>
                <Option name="outline_color" type="QString" value="150,110,20,255"/>
                <Option name="outline_style" type="QString" value="solid"/>
                <Option name="size" type="QString" value="5"/>
                <Option name="size_unit" type="QString" value="MM"/>
                <Option name="angle" type="QString" value="0"/>
                <Option name="scale_method" type="QString" value="diameter"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" type="QString" value=""/>
                  <Option name="properties" type="Map">
                    <Option name="angle" type="Map">
                      <Option name="active" type="bool" value="true"/>
                      <Option name="expression" type="QString" value="coalesce(direction_deg, 0)"/>
                      <Option name="type" type="int" value="3"/>
                    </Option>
                  </Option>
                  <Option name="type" type="QString" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
      </symbol>
    </symbols>
  </renderer-v2>
  <labeling type="simple">
    <settings>
      <text-style fieldName="coalesce(to_string(steps) || ' steps', 'how many steps?')" isExpression="1" fontFamily="DejaVu Sans" fontSize="7" fontSizeUnit="Point" textColor="40,40,40,255" namedStyle="Book">
        <text-buffer bufferDraw="1" bufferSize="0.6" bufferSizeUnits="MM" bufferColor="255,255,255,255" bufferOpacity="0.8"/>
      </text-style>
      <placement placement="0" centroidInside="1" centroidWhole="1" fitInPolygonOnly="0" placementFlags="10" dist="3" distUnits="MM"/>
      <rendering drawLabels="1" obstacle="0" scaleVisibility="1" scaleMin="0" scaleMax="800"/>
    </settings>
  </labeling>
</qgis>
