<!-- a --><c:ColorCorrection id='a&#x41;&amp;b' b="c > d"><SOPNode><Description><![CDATA[x]]></Description><Slope>+1 2e-3
3</Slope></SOPNode><SatNode/></c:ColorCorrection>