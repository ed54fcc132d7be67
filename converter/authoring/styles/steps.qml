<!DOCTYPE qgis PUBLIC "http://mrcc.com/qgis.dtd" "SYSTEM">
<qgis version="3.22.0" styleCategories="Symbology|Labeling|Fields|Forms" labelsEnabled="1">
  <renderer-v2 type="singleSymbol" symbollevels="0" enableorderby="0" forceraster="0">
    <symbols>
      <symbol name="0" type="line" alpha="1" clip_to_extent="1" force_rhr="0">
        <layer class="SimpleLine" enabled="1" pass="0" locked="0">
          <Option type="Map">
            <Option name="line_color" type="QString" value="190,130,20,255"/>
            <Option name="line_width" type="QString" value="0.5"/>
            <Option name="line_width_unit" type="QString" value="MM"/>
            <Option name="line_style" type="QString" value="solid"/>
            <Option name="capstyle" type="QString" value="flat"/>
            <Option name="joinstyle" type="QString" value="miter"/>
          </Option>
        </layer>
        <layer class="HashLine" enabled="1" pass="0" locked="0">
          <Option type="Map">
            <Option name="interval" type="QString" value="2"/>
            <Option name="interval_unit" type="QString" value="MM"/>
            <Option name="placement" type="QString" value="interval"/>
            <Option name="hash_length" type="QString" value="1.2"/>
            <Option name="hash_length_unit" type="QString" value="MM"/>
            <Option name="hash_angle" type="QString" value="0"/>
            <Option name="rotate" type="QString" value="1"/>
            <Option name="offset" type="QString" value="0.6"/>
            <Option name="offset_unit" type="QString" value="MM"/>
          </Option>
          <symbol name="@0@1" type="line" alpha="1" clip_to_extent="1" force_rhr="0">
            <layer class="SimpleLine" enabled="1" pass="0" locked="0">
              <Option type="Map">
                <Option name="line_color" type="QString" value="190,130,20,255"/>
                <Option name="line_width" type="QString" value="0.25"/>
                <Option name="line_width_unit" type="QString" value="MM"/>
                <Option name="line_style" type="QString" value="solid"/>
                <Option name="capstyle" type="QString" value="flat"/>
                <Option name="joinstyle" type="QString" value="miter"/>
              </Option>
            </layer>
          </symbol>
        </layer>
      </symbol>
    </symbols>
  </renderer-v2>
  <labeling type="simple">
    <settings>
      <text-style fieldName="coalesce(to_string(step_no), '')" isExpression="1" fontFamily="DejaVu Sans" fontSize="7" fontSizeUnit="Point" textColor="40,40,40,255" namedStyle="Book">
        <text-buffer bufferDraw="1" bufferSize="0.6" bufferSizeUnits="MM" bufferColor="255,255,255,255" bufferOpacity="0.8"/>
      </text-style>
      <placement placement="2" centroidInside="1" centroidWhole="1" fitInPolygonOnly="0" placementFlags="10" dist="0.5" distUnits="MM"/>
      <rendering drawLabels="1" obstacle="0" scaleVisibility="1" scaleMin="0" scaleMax="800"/>
    </settings>
  </labeling>
</qgis>
