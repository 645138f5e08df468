package org.u2sa.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.GoalList;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.Waypoint;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.testkit.ServiceKit;

/** The service: frames, waiting for states, modellers in use and in exchange, relevance, health. */
class WorldModelerTest {
  @TempDir private Path folder;
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private static StateInformation local(double x, double y, double psi) {
    return new StateInformation()
        .sensorName("StateEstimator")
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(x)
        .y(y)
        .psi(psi);
  }

  private static ObjectDescription seen(String uid, double ahead, double left) {
    return new Circle()
        .radius(0.2)
        .uid(uid)
        .objectType("barrel")
        .referenceFrame(ReferenceFrame.BODY)
        .x(ahead)
        .y(left)
        .sensorName("Camera");
  }

  private static RangeScan wallAhead(double range) {
    List<OptionalDouble> ranges = new ArrayList<>();
    for (int i = 0; i < 21; i++) {
      ranges.add(OptionalDouble.of(range));
    }
    return new RangeScan().sensorName("Lidar").maxRange(10.0).beams(-0.1, 0.01, ranges);
  }

  private List<ObjectDescription> objects() {
    return kit.latest(Channels.OBJECTS).orElseThrow().objects();
  }

  private OccupancyGrid grid() {
    return kit.latest(Channels.GRID).orElseThrow();
  }

  /** A tenth of a second, with a state and what was seen at its beginning. */
  private void tick(StateInformation state, ObjectDescription... seen) {
    kit.send(Channels.STATE, state);
    for (ObjectDescription each : seen) {
      kit.send(Channels.SENSED_OBJECTS, each);
    }
    kit.settle();
    kit.advance(0.1);
  }

  private String remarks() {
    return String.join("; ", kit.latest(Channels.HEALTH).orElseThrow().remarks());
  }

  @Test
  void reactive_noState_passesOnTheNewestInBodyAndForgets() {
    kit.with("MODELLERS", "REACTIVE").start(WorldModeler::new);
    kit.publish(Channels.SENSED_OBJECTS, seen("a", 3.0, 0.0));
    kit.advance(0.1);
    kit.publish(Channels.SENSED_OBJECTS, seen("b", 2.0, 1.0));
    kit.publish(Channels.SCANS, wallAhead(4.0));
    kit.advance(0.1);

    assertThat(objects()).extracting(ObjectDescription::uid).containsExactly("b", "Lidar");
    assertThat(objects().get(0).referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(((PointCloud) objects().get(1)).points()).hasSize(21);
    kit.advance(1.5);
    assertThat(objects()).isEmpty();
  }

  @Test
  void objects_seenThreeTimes_areOneCertainObjectInTheLocalFrame() {
    kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 1.0));
    tick(local(1.0, 0.0, 0.0), seen("a", 4.05, 0.95));
    assertThat(objects()).isEmpty();
    tick(local(2.0, 0.0, 0.0), seen("a", 2.95, 1.05));
    tick(local(3.0, 0.0, 0.0));

    ObjectDescription barrel = objects().get(0);
    assertThat(objects()).hasSize(1);
    assertThat(barrel).isInstanceOf(Circle.class);
    assertThat(barrel.referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_NED);
    assertThat(barrel.center().distanceTo(Point.of(5.0, -1.0, 0.0))).isLessThan(0.1);
    assertThat(barrel.motion().sigma().orElseThrow().x())
        .isCloseTo(Math.hypot(0.3 / Math.sqrt(3), 0.05), within(0.01));
    assertThat(barrel.confidence().orElseThrow()).isGreaterThan(0.9);
    kit.advance(1.0);
    assertThat(remarks()).contains("OBJECTS: 1 objects, 1 confirmed, 0 moving, 3 sightings");
  }

  @Test
  void objects_onTheEarth_areInGlobal() {
    Geodetic place = new Geodetic(-157.9, 21.3, 10.0);
    kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    StateInformation state =
        new StateInformation().x(-157.9).y(21.3).z(10.0).psi(Math.PI / 2.0).sensorName("E");
    for (int i = 0; i < 4; i++) {
      tick(state.copy(), seen("a", 20.0, 0.0));
    }

    ObjectDescription barrel = objects().get(0);
    assertThat(barrel.referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    Point enu = place.enuOf(Geodetic.of(barrel.center()));
    assertThat(enu.distanceTo(Point.of(20.0, 0.0, 0.0))).isLessThan(0.01);
  }

  @Test
  void objects_vehicleMovesBetweenStates_placedByTheStateOfTheirTime() {
    kit.with("MODELLERS", "OBJECTS").with("CONFIRM HITS", 1).start(WorldModeler::new);
    kit.publish(Channels.STATE, local(0.0, 0.0, 0.0));
    kit.advance(0.05);
    ObjectDescription between = seen("a", 5.0, 0.0);
    between.timestamp(50_000L);
    kit.publish(Channels.SENSED_OBJECTS, between);
    kit.advance(0.05);
    assertThat(objects()).isEmpty(); // waits for a state that is newer
    kit.publish(Channels.STATE, local(1.0, 0.0, 0.0)); // at 0.1 s: 10 m/s
    kit.advance(0.1);

    assertThat(objects().get(0).x()).isCloseTo(5.5, within(1e-6));
  }

  @Test
  void objects_walker_isAMovingSphereWithItsWay() {
    kit.with("MODELLERS", "OBJECTS").with("DEFAULT SIGMA", 0.1).start(WorldModeler::new);
    for (int i = 0; i <= 30; i++) {
      tick(local(0.0, 0.0, 0.0), seen("w", 5.0, -2.0 + 0.15 * i));
    }

    MovingSphere walker = (MovingSphere) objects().get(0);
    assertThat(walker.motion().velocity().orElseThrow().distanceTo(Point.of(0.0, -1.5, 0.0)))
        .isLessThan(0.3);
    assertThat(walker.radius()).isCloseTo(1.2, within(1e-9)); // its own 0.2 m and BUFFER
    assertThat(walker.trajectory()).hasSize(10);
    assertThat(walker.center().distanceTo(Point.of(5.0, -2.65, 0.0))).isLessThan(0.3);
  }

  @Test
  void objects_goneFromTheFieldOfView_areDropped() {
    kit.with("MODELLERS", "OBJECTS").with("FIELDS OF VIEW", "Camera: 90 deg, 10 m");
    kit.start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 0.0), seen("b", 5.0, 3.0));
    }
    assertThat(objects()).hasSize(2);
    for (int i = 0; i < 6; i++) {
      tick(local(0.0, 0.0, Math.PI), seen("c", 6.0, 0.0)); // looks the other way: no say
    }
    assertThat(objects()).hasSize(3);
    for (int i = 0; i < 6; i++) {
      tick(local(0.0, 0.0, 0.0), seen("b", 5.0, 3.0));
    }
    assertThat(objects()).extracting(ObjectDescription::uid).containsExactlyInAnyOrder("b", "c");
  }

  @Test
  void objects_scanThroughTheirPlace_areDropped() {
    kit.with("MODELLERS", "OBJECTS").with("SCANNERS SEE", "barrel").start(WorldModeler::new);
    for (int i = 0; i < 4; i++) {
      tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 0.0));
    }
    for (int i = 0; i < 8; i++) {
      kit.send(Channels.SCANS, wallAhead(5.0));
      tick(local(0.0, 0.0, 0.0));
    }
    assertThat(objects()).hasSize(1); // an echo where it is
    for (int i = 0; i < 8; i++) {
      kit.send(Channels.SCANS, wallAhead(8.0));
      tick(local(0.0, 0.0, 0.0));
    }
    assertThat(objects()).isEmpty();
  }

  @Test
  void grid_withStates_isInTheirFrameAndKeepsWhatItSaw() {
    kit.with("GRID RATE", 10).start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      kit.send(Channels.SCANS, wallAhead(4.05));
      tick(local(0.1 * i, 0.0, 0.0));
    }
    kit.advance(1.0);

    assertThat(grid().referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_NED);
    assertThat(OccupancyGrid.probability(grid().cellAt(Point.of(2.0, 0.0, 0.0)))).isLessThan(0.2);
    assertThat(grid().cellAt(Point.of(-2.0, 0.0, 0.0))).isEqualTo(OccupancyGrid.UNKNOWN);
    assertThat(remarks()).contains("GRID: 5 scans of 105 beams", "PLACED: 0 sightings, 5 scans");
  }

  @Test
  void grid_noState_isOfTheLastMomentAroundTheVehicle() {
    kit.with("MODELLERS", "GRID").with("GRID RATE", 10).start(WorldModeler::new);
    kit.publish(Channels.SCANS, wallAhead(4.05));
    kit.advance(0.1);
    assertThat(grid().referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(grid().cellAt(Point.of(4.05, 0.0, 0.0))).isGreaterThan((byte) 0);
    kit.publish(Channels.SCANS, wallAhead(6.05));
    kit.advance(0.1);
    assertThat(grid().cellAt(Point.of(4.05, 0.0, 0.0))).isLessThan((byte) 0);
    assertThat(grid().cellAt(Point.of(6.05, 0.0, 0.0))).isGreaterThan((byte) 0);
  }

  @Test
  void state_comesLateAndGoesAway_theMapFollows() {
    kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    for (int i = 0; i < 4; i++) {
      kit.publish(Channels.SENSED_OBJECTS, seen("a", 5.0, 0.0));
      kit.advance(0.1);
    }
    assertThat(objects().get(0).referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    tick(local(10.0, 0.0, Math.PI / 2.0));
    assertThat(objects().get(0).center().distanceTo(Point.of(10.0, 5.0, 0.0))).isLessThan(0.01);
    kit.advance(4.0);
    assertThat(objects().get(0).referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(objects().get(0).center().distanceTo(Point.of(5.0, 0.0, 0.0))).isLessThan(0.01);
  }

  @Test
  void sightings_withoutStateOfTheirTime_areCountedNotPlaced() {
    kit.with("MODELLERS", "OBJECTS").with("CONFIRM HITS", 1).start(WorldModeler::new);
    tick(local(0.0, 0.0, 0.0));
    kit.advance(1.0); // the newest state is a second old, and GAP is half of one
    kit.publish(Channels.SENSED_OBJECTS, seen("a", 5.0, 0.0));
    kit.advance(1.0);

    assertThat(objects()).isEmpty();
    assertThat(remarks()).contains("1 without a state of their time");
  }

  @Test
  void swap_whileMoving_objectsAndGridStay() {
    kit.with("GRID RATE", 10);
    WorldModeler first = kit.start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      kit.send(Channels.SCANS, wallAhead(4.05));
      tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 0.0));
    }
    OccupancyGrid before = grid();
    kit.forget();
    kit.swap(first, WorldModeler::new);
    tick(local(0.0, 0.0, 0.0));

    assertThat(objects()).extracting(ObjectDescription::uid).containsExactly("a");
    assertThat(grid().cells()).isEqualTo(before.cells());
  }

  @Test
  void modellers_changedWhileMoving_objectsStay() {
    kit.with("MODELLERS", "OBJECTS");
    WorldModeler modeler = kit.start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 0.0));
    }
    change("MODELLERS", "REACTIVE, GRID");
    kit.advance(0.1);

    assertThat(objects()).extracting(ObjectDescription::uid).containsExactly("a");
    kit.advance(1.0);
    assertThat(remarks()).contains("REACTIVE:").doesNotContain("OBJECTS:");
    assertThat(modeler.setVariable("MODELLERS", "REACTIV")).isFalse();
    assertThat(modeler.setVariable("MODELLERS", "REACTIVE, OBJECTS")).isFalse();
  }

  @Test
  void world_fileOfObjects_isPublishedNeverForgottenAndMatched() throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(
        file,
        "<world><reference>Local NED</reference>\n"
            + "<Circle><uid>barrel 1</uid><type>barrel</type><x>5</x><y>-1</y>"
            + "<radius>0.3</radius></Circle>\n"
            + "<MovingSphere><uid>cart</uid><x>0</x><y>50</y><radius>2</radius>"
            + "<xDot unit=\"km/h\">3.6</xDot><yDot>0</yDot></MovingSphere></world>");
    kit.with("MODELLERS", "OBJECTS").with("WORLD", file.toString()).start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      tick(local(0.0, 0.0, 0.0), seen("a", 4.9, 1.1));
    }
    kit.advance(1.5);

    assertThat(objects()).extracting(ObjectDescription::uid).containsExactly("barrel 1", "cart");
    assertThat(objects().get(0).x()).isEqualTo(5.0);
    assertThat(objects().get(1).x()).isCloseTo(2.0, within(0.11)); // 1 m/s since the start
  }

  @Test
  void world_moversNotKnownBeforehand_onlyWhatStandsIsPublished() throws IOException {
    kit.with("MODELLERS", "OBJECTS").with("WORLD", mastAndCart().toString());
    kit.with("WORLD MOVERS", false).start(WorldModeler::new);
    tick(local(0.0, 0.0, 0.0), seen("a", 4.9, 1.1));
    kit.advance(0.5);
    assertThat(objects()).extracting(ObjectDescription::uid).containsExactly("mast");
  }

  private Path mastAndCart() throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(
        file,
        "<world><reference>Local NED</reference>"
            + "<Circle><uid>mast</uid><x>5</x><y>-1</y><radius>0.3</radius></Circle>"
            + "<MovingSphere><uid>cart</uid><x>0</x><y>50</y><radius>2</radius>"
            + "<xDot>1</xDot><yDot>0</yDot></MovingSphere></world>");
    return file;
  }

  private void change(String variable, String value) {
    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange().serviceName("WorldModeler").variableName(variable).value(value));
  }

  private void stand(int ticks) {
    for (int i = 0; i < ticks; i++) {
      tick(local(0.0, 0.0, 0.0));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"OBJECTS", "REACTIVE"})
  void worldMovers_changedWhileRunning_moverGoesAndComesBackWhereItIsByNow(String modeller)
      throws IOException {
    kit.with("MODELLERS", modeller).with("WORLD", mastAndCart().toString());
    kit.start(WorldModeler::new);
    stand(10);
    change("WORLD MOVERS", "false");
    stand(20);
    assertThat(objects()).extracting(ObjectDescription::uid).containsExactly("mast");

    change("WORLD MOVERS", "true");
    stand(10);
    assertThat(objects()).extracting(ObjectDescription::uid).containsExactly("mast", "cart");
    assertThat(objects().get(1).x()).isCloseTo(4.0, within(0.11)); // 1 m/s since the start
  }

  @Test
  void world_serviceSwappedOrModellersChanged_moverIsWhereItWouldHaveBeen() throws IOException {
    kit.with("MODELLERS", "OBJECTS").with("WORLD", mastAndCart().toString());
    WorldModeler modeler = kit.start(WorldModeler::new);
    stand(10);
    kit.swap(modeler, WorldModeler::new);
    stand(10);
    assertThat(objects().get(1).x()).isCloseTo(2.0, within(0.11));

    change("MODELLERS", "REACTIVE");
    stand(10);
    assertThat(objects().get(1).x()).isCloseTo(3.0, within(0.11));
    change("MODELLERS", "OBJECTS");
    stand(10);
    assertThat(objects()).extracting(ObjectDescription::uid).containsExactly("mast", "cart");
    assertThat(objects().get(1).x()).isCloseTo(4.0, within(0.11));
  }

  @Test
  void world_wrongFile_refusesToStartNamingTheLine() throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(file, "<world>\n<Circel><x>1</x></Circel></world>");
    kit.with("WORLD", file.toString());
    assertThatThrownBy(() -> kit.start(WorldModeler::new))
        .hasMessageContaining("world.xml, line 2, <Circel>")
        .hasMessageContaining("Circle");
  }

  @Test
  void relevance_goalNamesATypeOfObject_othersAreLeftOutButNotWhatMustBeAvoided() {
    kit.with("MODELLERS", "REACTIVE").start(WorldModeler::new);
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(new Seek().objectType("buoy").goal("1"))));
    kit.publish(Channels.SENSED_OBJECTS, seen("barrel", 3.0, 0.0));
    kit.send(Channels.SENSED_OBJECTS, seen("rock", 3.0, 1.0).level(ObjectLevel.AVOID_ALWAYS));
    kit.send(Channels.SENSED_OBJECTS, seen("buoy", 3.0, 2.0).objectType("buoy"));
    kit.settle();
    kit.advance(0.1);
    assertThat(objects())
        .extracting(ObjectDescription::uid)
        .containsExactlyInAnyOrder("rock", "buoy");

    Waypoint anything = new Waypoint().x(1.0).y(1.0).horizontalThreshold(1.0);
    anything.uid("2");
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(anything)));
    kit.advance(0.1);
    assertThat(objects()).hasSize(3);
  }

  @Test
  void modellers_ofAnExtension_workBesideTheOthers() {
    kit.with("MODELLERS", "REACTIVE, LIGHTHOUSE").with("LIGHTHOUSE", 250.0);
    kit.start(WorldModeler::new);
    kit.publish(Channels.SENSED_OBJECTS, seen("a", 3.0, 0.0));
    kit.advance(1.5);

    assertThat(objects()).extracting(ObjectDescription::x).contains(250.0);
    assertThat(remarks()).contains("LIGHTHOUSE: shines");
  }

  /** A goal of a vehicle's own, as thesis 3.2.3.3 describes one. */
  static final class Seek extends GoalInformation {
    private static final Schema<Seek> SCHEMA =
        Schema.of("Seek", Seek.class, Seek::new, GoalInformation.TYPE);
    private static final ValueField<Seek, String> OBJECT_TYPE = SCHEMA.requiredText("objectType");
    static final MessageType<Seek> TYPE = SCHEMA.build();

    @Override
    public MessageType<Seek> type() {
      return TYPE;
    }

    Seek objectType(String type) {
      return put(OBJECT_TYPE, type);
    }

    Seek goal(String uid) {
      uid(uid);
      return this;
    }
  }
}
