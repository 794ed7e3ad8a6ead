<?xml version="1.0" encoding="UTF-8"?>
<ColorCorrection xmlns="urn:ASC:CDL:v1.2" id="warm">
    <SOPNode>
      <Slope>1.1 1.0 0.9</Slope>
      <Offset>0.01 0.0 -0.01</Offset>
      <Power>0.9 1.0 1.1</Power>
    </SOPNode>
    <SatNode>
      <Saturation>1</Saturation>
    </SatNode>
</ColorCorrection>
