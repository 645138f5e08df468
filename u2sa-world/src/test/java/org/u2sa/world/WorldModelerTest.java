package org.u2sa.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.world.ModelledWorld.local;
import static org.u2sa.world.ModelledWorld.seen;
import static org.u2sa.world.ModelledWorld.wallAhead;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.PointCloud;

/** The service: frames, waiting for states, modellers in use and in exchange, relevance, health. */
class WorldModelerTest {
  private final ModelledWorld world = new ModelledWorld();

  @AfterEach
  void close() {
    world.close();
  }

  @Test
  void reactive_noState_passesOnTheNewestInBodyAndForgets() {
    world.kit.with("MODELLERS", "REACTIVE").start(WorldModeler::new);
    world.kit.publish(Channels.SENSED_OBJECTS, seen("a", 3.0, 0.0));
    world.kit.advance(0.1);
    world.kit.publish(Channels.SENSED_OBJECTS, seen("b", 2.0, 1.0));
    world.kit.publish(Channels.SCANS, wallAhead(4.0));
    world.kit.advance(0.1);

    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("b", "Lidar");
    assertThat(world.objects().get(0).referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(((PointCloud) world.objects().get(1)).points()).hasSize(21);
    world.kit.advance(1.5);
    assertThat(world.objects()).isEmpty();
  }

  @Test
  void scan_datedInTheFuture_isCountedAndDoesNotWait() {
    world.kit.with("MODELLERS", "REACTIVE").start(WorldModeler::new);
    RangeScan ahead = wallAhead(4.0);
    ahead.timestamp(world.kit.clock().micros() + 1_100_000);
    world.kit.publish(Channels.SCANS, ahead);
    world.kit.advance(2.0);

    assertThat(world.remarks()).contains("0 scans", "1 from the future");
  }

  @Test
  void grid_withStates_isInTheirFrameAndKeepsWhatItSaw() {
    world.kit.with("GRID RATE", 10).start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      world.kit.send(Channels.SCANS, wallAhead(4.05));
      world.tick(local(0.1 * i, 0.0, 0.0));
    }
    world.kit.advance(1.0);

    assertThat(world.grid().referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_NED);
    assertThat(OccupancyGrid.probability(world.grid().cellAt(Point.of(2.0, 0.0, 0.0))))
        .isLessThan(0.2);
    assertThat(world.grid().cellAt(Point.of(-2.0, 0.0, 0.0))).isEqualTo(OccupancyGrid.UNKNOWN);
    assertThat(world.remarks())
        .contains("GRID: 5 scans of 105 beams", "PLACED: 0 sightings, 5 scans");
  }

  @Test
  void grid_noState_isOfTheLastMomentAroundTheVehicle() {
    world.kit.with("MODELLERS", "GRID").with("GRID RATE", 10).start(WorldModeler::new);
    world.kit.publish(Channels.SCANS, wallAhead(4.05));
    world.kit.advance(0.1);
    assertThat(world.grid().referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(world.grid().cellAt(Point.of(4.05, 0.0, 0.0))).isGreaterThan((byte) 0);
    world.kit.publish(Channels.SCANS, wallAhead(6.05));
    world.kit.advance(0.1);
    assertThat(world.grid().cellAt(Point.of(4.05, 0.0, 0.0))).isLessThan((byte) 0);
    assertThat(world.grid().cellAt(Point.of(6.05, 0.0, 0.0))).isGreaterThan((byte) 0);
  }

  @Test
  void state_comesLateAndGoesAway_theMapFollows() {
    world.kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    for (int i = 0; i < 4; i++) {
      world.kit.publish(Channels.SENSED_OBJECTS, seen("a", 5.0, 0.0));
      world.kit.advance(0.1);
    }
    assertThat(world.objects().get(0).referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    world.tick(local(10.0, 0.0, Math.PI / 2.0));
    assertThat(world.objects().get(0).center().distanceTo(Point.of(10.0, 5.0, 0.0)))
        .isLessThan(0.01);
    world.kit.advance(4.0);
    assertThat(world.objects().get(0).referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(world.objects().get(0).center().distanceTo(Point.of(5.0, 0.0, 0.0)))
        .isLessThan(0.01);
  }

  @Test
  void sightings_withoutStateOfTheirTime_areCountedNotPlaced() {
    world.kit.with("MODELLERS", "OBJECTS").with("CONFIRM HITS", 1).start(WorldModeler::new);
    world.tick(local(0.0, 0.0, 0.0));
    world.kit.advance(1.0); // the newest state is a second old, and GAP is half of one
    world.kit.publish(Channels.SENSED_OBJECTS, seen("a", 5.0, 0.0));
    world.kit.advance(1.0);

    assertThat(world.objects()).isEmpty();
    assertThat(world.remarks()).contains("1 without a state at their time");
  }

  @Test
  void swap_whileMoving_objectsAndGridStay() {
    world.kit.with("GRID RATE", 10);
    WorldModeler first = world.kit.start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      world.kit.send(Channels.SCANS, wallAhead(4.05));
      world.tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 0.0));
    }
    OccupancyGrid before = world.grid();
    world.kit.forget();
    world.kit.swap(first, WorldModeler::new);
    world.tick(local(0.0, 0.0, 0.0));

    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("a");
    assertThat(world.grid().cells()).isEqualTo(before.cells());
  }

  @Test
  void modellers_changedWhileMoving_objectsStay() {
    world.kit.with("MODELLERS", "OBJECTS");
    WorldModeler modeler = world.kit.start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      world.tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 0.0));
    }
    world.change("MODELLERS", "REACTIVE, GRID");
    world.kit.advance(0.1);

    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("a");
    world.kit.advance(1.0);
    assertThat(world.remarks()).contains("REACTIVE:").doesNotContain("OBJECTS:");
    assertThat(modeler.setVariable("MODELLERS", "REACTIV")).isFalse();
    assertThat(modeler.setVariable("MODELLERS", "REACTIVE, OBJECTS")).isFalse();
  }

  @Test
  void relevance_goalNamesATypeOfObject_onlyPassableObjectsOfOtherTypesAreLeftOut() {
    world.kit.with("MODELLERS", "REACTIVE").start(WorldModeler::new);
    world.kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(new Seek().objectType("buoy").goal("1"))));
    world.kit.publish(Channels.SENSED_OBJECTS, seen("barrel", 3.0, 0.0));
    world.kit.send(Channels.SENSED_OBJECTS, seen("rock", 3.0, 1.0).level(ObjectLevel.AVOID_ALWAYS));
    world.kit.send(Channels.SENSED_OBJECTS, seen("buoy", 3.0, 2.0).objectType("buoy"));
    world.kit.send(Channels.SENSED_OBJECTS, seen("weed", 3.0, 3.0).level(ObjectLevel.HINDRANCE));
    world.kit.settle();
    world.kit.advance(0.1);
    assertThat(world.objects())
        .extracting(ObjectDescription::uid)
        .containsExactlyInAnyOrder("barrel", "rock", "buoy");

    Waypoint anything = new Waypoint().x(1.0).y(1.0).horizontalThreshold(1.0);
    anything.uid("2");
    world.kit.publish(Channels.GOALS, new GoalList().goals(List.of(anything)));
    world.kit.advance(0.1);
    assertThat(world.objects()).hasSize(4);
  }

  @Test
  void modellers_ofAnExtension_workBesideTheOthers() {
    world.kit.with("MODELLERS", "REACTIVE, LIGHTHOUSE").with("LIGHTHOUSE", 250.0);
    world.kit.start(WorldModeler::new);
    world.kit.publish(Channels.SENSED_OBJECTS, seen("a", 3.0, 0.0));
    world.kit.advance(1.5);

    assertThat(world.objects()).extracting(ObjectDescription::x).contains(250.0);
    assertThat(world.remarks()).contains("LIGHTHOUSE: shines");
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

  @Test
  void scans_withoutBeamsOrLongerThanAScanTakes_areCountedAndTheMapGoesOn() {
    world.kit.with("MODELLERS", "GRID,OBJECTS").start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      world.kit.send(Channels.SCANS, new RangeScan().sensorName("Lidar").maxRange(10.0));
      world.kit.send(Channels.SCANS, wallAhead(4.0).sensorName("Other").timeIncrement(1e6));
      world.tick(local(0.0, 0.0, 0.0), seen("barrel", 3.0, 0.0));
    }
    assertThat(world.objects()).hasSize(1);
    assertThat(world.kit.latest(Channels.HEALTH).orElseThrow().lastError()).isEmpty();
    assertThat(world.remarks()).contains("8 scans without beams or too long");
  }
}
