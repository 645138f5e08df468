package org.u2sa.world.xml;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.messages.shape.Polygon;

/** World XML: the thesis's snippet, all classes, units, and what is refused where. */
class WorldFileTest {
  private static WorldFile world(String content) {
    String xml = "<world>" + content + "</world>";
    return WorldFile.parse(
        XmlReader.read(new ByteArrayInputStream(xml.getBytes(UTF_8)), "w.xml", "world"),
        StandardTypes.registry());
  }

  private static void assertRefused(String content, String... parts) {
    assertThatThrownBy(() -> world(content))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith("w.xml, line ")
        .hasMessageContainingAll(parts);
  }

  @Test
  void parse_snippetOfThesis_loadsUnchanged() {
    WorldFile world =
        world("\n<Circle>\n  <uid>Circle1</uid>\n  <x>4</x>\n  <y>8</y>\n</Circle>\n"); // 3.2.3.3

    assertThat(world.objects()).hasSize(1);
    Circle circle = (Circle) world.object("Circle1").orElseThrow();
    assertThat(circle.center()).isEqualTo(Point.of(4.0, 8.0, 0.0));
  }

  @Test
  void parse_referenceOfTheWorld_isThatOfObjectsWithoutTheirOwn() {
    WorldFile world =
        world(
            "<reference>Local NED</reference>"
                + "<box><x>400</x><y unit=\"ft\">10</y><psi unit=\"deg\">90</psi></box>"
                + "<circle><reference>Global</reference><x>4</x><y>8</y></circle>");

    Box box = (Box) world.objects().get(0);
    assertThat(box.uid()).isEqualTo("Box 1");
    assertThat(box.referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_NED);
    assertThat(box.y()).isEqualTo(3.048);
    assertThat(box.psi()).isEqualTo(Math.PI / 2.0);
    assertThat(world.objects().get(1).referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
  }

  @Test
  void parse_pointsInEitherForm_centreIsTheirMiddle() {
    WorldFile world =
        world(
            "<reference>Local ENU</reference>"
                + "<pointCloud><points><point>1 2</point><point><x>3</x><y unit=\"cm\">400</y>"
                + "<z>2</z></point></points></pointCloud>"
                + "<polygon><points>0 0; 4 0; 4 3; 0 3</points><height>2</height></polygon>"
                + "<polyLine><points>0 0; 9 0</points><width>0.1</width></polyLine>");

    PointCloud cloud = (PointCloud) world.objects().get(0);
    assertThat(cloud.points()).containsExactly(Point.of(1, 2, 0), Point.of(3, 4, 2));
    assertThat(cloud.center()).isEqualTo(Point.of(2, 3, 1));
    assertThat(((Polygon) world.objects().get(1)).distanceTo(Point.of(6, 1, 0))).isEqualTo(2.0);
    assertThat(((PolyLine) world.objects().get(2)).width()).isEqualTo(0.1);
  }

  @Test
  void parse_pointsOnBothSidesOfTheDateLine_centreIsAmongThem() {
    Polygon polygon =
        (Polygon)
            world(
                    "<polygon><points>179.99 -17; -179.98 -17; -179.98 -16.99; 179.99 -16.99"
                        + "</points></polygon>")
                .objects()
                .get(0);

    assertThat(polygon.x()).isCloseTo(-179.995, within(1e-9));
    assertThat(polygon.y()).isCloseTo(-16.995, within(1e-9));
  }

  @Test
  void parse_classOfAPoint_isAnObjectDescription() {
    ObjectDescription point =
        world("<objectDescription><x>1</x><y>2</y><level>avoid always</level></objectDescription>")
            .objects()
            .get(0);
    assertThat(point.level()).isPresent();
  }

  @Test
  void parse_wrong_saysWhereAndWhatWasExpected() {
    assertRefused("<Circel/>", "<Circel>", "did you mean", "Circle");
    assertRefused("<waypoint/>", "is not a class of objects");
    assertRefused("<shapeDescription/>", "is not a class of objects");
    assertRefused("\n<circle><x>1</x></circle>", "line 2", "<circle>", "lacks <y>");
    assertRefused("<circle/>", "lacks <x> and <y>");
    assertRefused("<circle><x>200</x><y>1</y></circle>", "200.0", "longitude");
    assertRefused("<circle><x>NaN</x><y>1</y></circle>", "NaN");
    assertRefused("<circle><x>1</x><x>2</x><y>1</y></circle>", "appears twice");
    assertRefused("<circle><x>1</x><y>1</y><radius>-1</radius></circle>", "radius", "-1");
    assertRefused("<circle><x>1</x><y>1</y><radius unit=\"kg\">1</radius></circle>", "kg");
    assertRefused("<circle><x>1</x><y>1</y><radus>1</radus></circle>", "<radus>", "radius");
    assertRefused("<reference>Mars</reference>", "<reference>", "Mars");
    assertRefused(
        "<circle><uid>a</uid><x>1</x><y>1</y></circle><box><uid>a</uid><x>1</x><y>1</y></box>",
        "uid \"a\" already");
    assertRefused("<line><points>1 2; 3</points></line>", "\"3\" is not a point");
    assertRefused("<line><points>1 2; x 4</points></line>", "is not a point");
    assertRefused("<line><points>1 2; 1e999 4</points></line>", "<points>");
    assertRefused("<line><points/></line>", "contains no points");
    assertRefused("<line><points>1 2; 3 95</points></line>", "latitude");
    assertRefused("<circle><timestamp>3</timestamp><x>1</x><y>1</y></circle>", "timestamp");
  }
}
