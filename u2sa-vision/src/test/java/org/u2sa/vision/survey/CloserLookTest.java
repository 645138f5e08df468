package org.u2sa.vision.survey;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.StringReader;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.mission.MissionOrder;
import org.w3c.dom.Document;
import org.xml.sax.InputSource;

class CloserLookTest {
  @Test
  void order_cameraNamedWithMarkup_isXmlThatNamesIt() throws Exception {
    SearchArea area = new SearchArea().resolution(0.05).ground(10.0);

    MissionOrder order =
        new CloserLook(0.6).order(area, List.of(new Geodetic(10.0, 50.0, 0.0)), "R&D <1>", 1, 7L);

    Document goals =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(new InputSource(new StringReader(order.goals().orElseThrow())));
    assertThat(goals.getElementsByTagName("name").item(0).getTextContent())
        .isEqualTo("R&D <1> look 1");
  }
}
