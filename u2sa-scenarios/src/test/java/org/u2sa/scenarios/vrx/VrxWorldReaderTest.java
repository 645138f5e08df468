package org.u2sa.scenarios.vrx;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;

class VrxWorldReaderTest {
  static final Path WORLDS = Path.of("../missions/vrx");

  @TempDir private Path folder;

  @Test
  void read_station_hasGoalWindAndWaves() {
    VrxWorld world = VrxWorldReader.read(WORLDS.resolve("station.sdf"));

    assertThat(world.task()).isEqualTo(VrxTask.STATIONKEEPING);
    assertThat(world.goals()).hasSize(1);
    assertThat(world.goals().get(0).latitudeDeg()).isEqualTo(-33.722750);
    assertThat(world.goals().get(0).headingRad()).isCloseTo(Math.PI / 2 - 2.5, within(1e-12));
    assertThat(world.wind().meanMps()).isEqualTo(6.0);
    assertThat(world.wind().sigmaMps()).isCloseTo(0.75, within(1e-12));
    double from = Math.toDegrees(world.wind().fromRad()); // it blows to 200° anticlockwise of east
    assertThat(Math.IEEEremainder(from - 70.0, 360.0)).isCloseTo(0.0, within(1e-9));
    assertThat(world.sea().periodS()).isEqualTo(5.0);
    assertThat(world.sea().heightM()).isBetween(0.3, 0.5);
    assertThat(world.times()).isEqualTo(new VrxWorld.Times(10.0, 40.0));
  }

  @Test
  void read_gates_leadUpwardsTimesLeftMinusRight() {
    VrxWorld world = VrxWorldReader.read(WORLDS.resolve("gates.sdf"));

    assertThat(world.gates()).hasSize(3);
    VrxWorld.Gate first = world.gates().get(0);
    assertThat(first.centre()).isEqualTo(Point.of(-532.0, 185.0, 0.0));
    assertThat(first.widthM()).isEqualTo(16.0);
    assertThat(first.headingRad()).isCloseTo(0.0, within(1e-9)); // north
    assertThat(world.buoys()).hasSize(8);
  }

  @Test
  void read_courseInAModel_placesItsMarkersByItsPose() throws IOException {
    Path model = Files.createDirectories(folder.resolve("models/course")).resolve("model.sdf");
    Files.writeString(
        model,
        "<sdf version=\"1.6\"><model name=\"course\">"
            + marker("left", "0 5")
            + marker("right", "0 -5")
            + "</model></sdf>");
    Path world = Files.createDirectories(folder.resolve("worlds/2023")).resolve("path.sdf");
    String text = Files.readString(WORLDS.resolve("gates.sdf"));
    Files.writeString(
        world,
        text.replaceFirst(
                "(?s)<include>.*</include>",
                "<include><uri>model://course</uri><pose>100 50 0 0 0 1.5707963267948966</pose></include>")
            .replaceFirst(
                "(?s)<gates>.*</gates>",
                "<gates><gate><left_marker>left</left_marker><right_marker>right</right_marker></gate></gates>"));

    VrxWorld read = VrxWorldReader.read(world);

    assertThat(read.gates().get(0).left().distanceTo(Point.of(95.0, 50.0, 0.0))).isLessThan(1e-9);
    assertThat(read.gates().get(0).right().distanceTo(Point.of(105.0, 50.0, 0.0))).isLessThan(1e-9);
  }

  private static String marker(String name, String place) {
    return "<include><name>"
        + name
        + "</name><pose>"
        + place
        + " 0 0 0 0</pose><uri>model://mb_marker_buoy_red</uri></include>";
  }

  @Test
  void read_wrongGoal_namesFileLineAndValue() throws IOException {
    Path world = folder.resolve("wrong.sdf");
    String text = Files.readString(WORLDS.resolve("station.sdf"));
    Files.writeString(world, text.replace("-33.722750 150.674060 2.5", "-33.7 east 2.5"));

    assertThatThrownBy(() -> VrxWorldReader.read(world))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("wrong.sdf, line")
        .hasMessageContaining("<goal_pose>")
        .hasMessageContaining("\"east\" is not a number");
  }

  @Test
  void read_animals_swimAndHaveParts() {
    VrxWorld world = VrxWorldReader.read(WORLDS.resolve("animals.sdf"));

    assertThat(world.wildlife().animals())
        .extracting(Wildlife.Animal::part)
        .containsExactly(Wildlife.Part.AVOID, Wildlife.Part.CLOCKWISE, Wildlife.Part.ANTICLOCKWISE);
    assertThat(world.wildlife().engagementM()).isEqualTo(10.0);
    assertThat(world.wildlife().animals().get(1).mover().at(5.0).position())
        .isNotEqualTo(Point.of(-520.0, 190.0, 0.0));
  }

  @Test
  void read_dock_hasBaysSequenceAndZonesInItsOwnAxes() {
    Docking docking = VrxWorldReader.read(WORLDS.resolve("dock.sdf")).docking();

    assertThat(docking.sequence()).containsExactly(Colour.RED, Colour.GREEN, Colour.BLUE);
    assertThat(docking.bays())
        .extracting(Docking.Bay::sign)
        .containsExactly("red triangle", "red cross", "blue cross");
    assertThat(docking.most()).isEqualTo(30.0);
    Point inBay2 = // x 1.5, y 9 m of the dock
        Point.of(
            -525.0 + 1.5 * Math.cos(1.2) - 9.0 * Math.sin(1.2),
            192.0 + 1.5 * Math.sin(1.2) + 9.0 * Math.cos(1.2),
            0.0);
    assertThat(docking.isInside(1, inBay2)).isTrue();
    assertThat(docking.isInside(0, inBay2)).isFalse();
    assertThat(docking.isBefore(1, inBay2)).isFalse();
  }

  @Test
  void read_unknownGoalOfAnAnimal_isRefused() throws IOException {
    Path world = folder.resolve("wrong.sdf");
    String text = Files.readString(WORLDS.resolve("animals.sdf"));
    Files.writeString(world, text.replace("<goal>avoid", "<goal>feed"));

    assertThatThrownBy(() -> VrxWorldReader.read(world))
        .hasMessageContaining("wrong.sdf, line")
        .hasMessageContaining("\"feed\": expected avoid");
  }

  @Test
  void read_worldWithoutATask_saysWhatIsExpected() throws IOException {
    Path world = folder.resolve("none.sdf");
    String text = Files.readString(WORLDS.resolve("station.sdf"));
    Files.writeString(world, text.replace("vrx::Stationkeeping", "vrx::Perception"));

    assertThatThrownBy(() -> VrxWorldReader.read(world))
        .hasMessageContaining("expected one of StationkeepingScoringPlugin");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          <latitude_deg>[^<]*                       | <latitude_deg>1e6                  | <latitude_deg>: 1000000.0 deg: expected a latitude of -90 to 90
          -33.722650 150                            | -133.722650 150                    | <pose>: -133.72265 deg: expected a latitude of -90 to 90
          "period" value . type: DOUBLE double_value: 5.0 | "period" double_value: 1e.e  | <message>: "1e.e" is not a number
          "period" value . type: DOUBLE double_value: 5.0 | "period" double_value: 0     | <message>: period: expected above 0 s
          <ready_state_duration>10                  | <ready_state_duration>-1e6         | <ready_state_duration>: -1000000.0 s: expected above 0
          (?s)<waypoints>.*</waypoints>             | <waypoints></waypoints>            | <waypoints>: 0 <waypoint>; expected 1 to 9
          (<waypoint><pose>.*?</waypoint>)          | $1$1$1$1$1$1$1$1$1$1$1$1$1$1$1$1$1 | <waypoints>: 18 <waypoint>; expected 1 to 9
          """)
  void read_absurdWorld_isRefusedWithFileAndLine(String what, String by, String message)
      throws IOException {
    Path world = folder.resolve("absurd.sdf");
    String text = Files.readString(WORLDS.resolve("waypoints.sdf"));
    Files.writeString(world, text.replaceFirst(what, by));

    assertThatThrownBy(() -> VrxWorldReader.read(world))
        .isInstanceOf(BadInputException.class)
        .hasMessageMatching("(?s).*absurd.sdf, line \\d+, " + Pattern.quote(message) + ".*");
  }

  @ParameterizedTest
  @CsvSource({"1, models within models", "30, <include>"})
  void read_modelThatIncludesItself_isRefused(int times, String message) throws IOException {
    String itself = "<include><uri>model://course</uri></include>";
    Path model = Files.createDirectories(folder.resolve("models/course")).resolve("model.sdf");
    Files.writeString(
        model, "<sdf><model name=\"course\">" + itself.repeat(times) + "</model></sdf>");
    Path world = folder.resolve("loop.sdf");
    String text = Files.readString(WORLDS.resolve("station.sdf"));
    Files.writeString(world, text.replace("</world>", itself + "</world>"));

    assertThatThrownBy(() -> VrxWorldReader.read(world))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("model.sdf, line")
        .hasMessageContaining(message);
  }
}
