package org.u2sa.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.u2sa.world.ModelledWorld.local;
import static org.u2sa.world.ModelledWorld.seen;
import static org.u2sa.world.ModelledWorld.wallAhead;

import java.util.Collections;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.MovingSphere;

/** The map of objects: what is seen becomes certain, moves, is gone. */
class MappedObjectsTest {
  private final ModelledWorld world = new ModelledWorld();
  private final Random errors = new Random(14L);

  @AfterEach
  void close() {
    world.close();
  }

  @Test
  void objects_seenThreeTimes_areOneCertainObjectInTheLocalFrame() {
    world.kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    world.tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 1.0));
    world.tick(local(1.0, 0.0, 0.0), seen("a", 4.05, 0.95));
    assertThat(world.objects()).isEmpty();
    world.tick(local(2.0, 0.0, 0.0), seen("a", 2.95, 1.05));
    world.tick(local(3.0, 0.0, 0.0));

    ObjectDescription barrel = world.objects().get(0);
    assertThat(world.objects()).hasSize(1);
    assertThat(barrel).isInstanceOf(Circle.class);
    assertThat(barrel.referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_NED);
    assertThat(barrel.center().distanceTo(Point.of(5.0, -1.0, 0.0))).isLessThan(0.1);
    assertThat(barrel.motion().sigma().orElseThrow().x())
        .isCloseTo(Math.hypot(0.3 / Math.sqrt(3), 0.05), within(0.01));
    assertThat(barrel.confidence().orElseThrow()).isGreaterThan(0.9);
    world.kit.advance(1.0);
    assertThat(world.remarks()).contains("OBJECTS: 1 objects, 1 confirmed, 0 moving, 3 sightings");
  }

  /** A thousand of them would fill the memory: each is kept as long as its object is known. */
  @Test
  void objects_sightingOfThirtyThousandPointsFromAnotherProcess_isRefusedAndCounted()
      throws MalformedMessageException {
    world.kit.with("MODELLERS", "OBJECTS").with("CONFIRM HITS", 1).start(WorldModeler::new);
    MovingSphere absurd =
        new MovingSphere().trajectory(Collections.nCopies(30_000, Point.of(1.0, 2.0, 3.0)));
    absurd.uid("absurd").referenceFrame(ReferenceFrame.BODY).x(3.0).y(0.0).sensorName("Camera");
    absurd.timestamp(world.kit.clock().micros());
    U2SAData received =
        new MessageCodec(StandardTypes.registry()).decode(absurd.typeChain(), absurd.serialize());
    world.tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 1.0), (ObjectDescription) received);
    world.tick(local(0.0, 0.0, 0.0));
    world.kit.advance(1.0);

    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("a");
    assertThat(world.remarks()).contains("1 rejected for their length");
  }

  @Test
  void objects_hundredsAtOnceByOneSensor_leaveRoomForOthersAndAreCounted() {
    world.kit.with("MODELLERS", "OBJECTS").with("CONFIRM HITS", 1).start(WorldModeler::new);
    ObjectDescription[] all = new ObjectDescription[901];
    for (int i = 0; i < 900; i++) {
      all[i] = seen("c" + i, 2.0 + i % 50, i / 50.0).sensorName("Crowd");
    }
    all[900] = seen("a", -5.0, 1.0);
    world.tick(local(0.0, 0.0, 0.0), all);
    world.tick(local(0.0, 0.0, 0.0));
    world.kit.advance(1.0);

    assertThat(world.objects()).extracting(ObjectDescription::uid).contains("a");
    assertThat(world.remarks()).contains("600 objects too many at once");
  }

  /** What messages may carry: claims without any error, or beyond all measure. */
  @Test
  void objects_absurdClaims_costNoneOfTheOthers() {
    world
        .kit
        .with("MODELLERS", "OBJECTS")
        .with("USUAL SPEED", 1.0)
        .with("CONFIRM HITS", 1)
        .start(WorldModeler::new);
    double[] claims = {0.0, 1e-300, 1e-160, 1e-9, 1.0, 1e6, 1e15};
    Random random = new Random(5L);
    for (int i = 0; i < 400; i++) {
      ObjectDescription[] both = {null, null, seen("a", 5.0, 1.0)};
      for (int k = 0; k < 2; k++) {
        both[k] = seen("b" + i % 3, -5.0 + random.nextGaussian(), 1.0);
        double sigma = claims[random.nextInt(claims.length)];
        double speed = random.nextBoolean() ? claims[random.nextInt(claims.length)] : -1e15;
        both[k]
            .motion()
            .sigma(Point.of(sigma, claims[random.nextInt(claims.length)], sigma))
            .velocity(Point.of(speed, claims[random.nextInt(claims.length)], 0.0))
            .velocitySigma(claims[random.nextInt(claims.length)]);
        both[k].timestamp(world.kit.clock().micros());
      }
      world.tick(local(0.0, 0.0, 0.0), both);
      assertThat(world.objects()).extracting(ObjectDescription::uid).contains("a");
    }

    assertThat(world.kit.log("WorldModeler")).noneMatch(line -> line.contains("Exception"));
  }

  @Test
  void objects_onTheEarth_areInGlobal() {
    Geodetic place = new Geodetic(-157.9, 21.3, 10.0);
    world.kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    StateInformation state =
        new StateInformation().x(-157.9).y(21.3).z(10.0).psi(Math.PI / 2.0).sensorName("E");
    for (int i = 0; i < 4; i++) {
      world.tick(state.copy(), seen("a", 20.0, 0.0));
    }

    ObjectDescription barrel = world.objects().get(0);
    assertThat(barrel.referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    Point enu = place.enuOf(Geodetic.of(barrel.center()));
    assertThat(enu.distanceTo(Point.of(20.0, 0.0, 0.0))).isLessThan(0.01);
  }

  @Test
  void objects_vehicleMovesBetweenStates_placedByTheStateOfTheirTime() {
    world.kit.with("MODELLERS", "OBJECTS").with("CONFIRM HITS", 1).start(WorldModeler::new);
    world.kit.publish(Channels.STATE, local(0.0, 0.0, 0.0));
    world.kit.advance(0.05);
    ObjectDescription between = seen("a", 5.0, 0.0);
    between.timestamp(50_000L);
    world.kit.publish(Channels.SENSED_OBJECTS, between);
    world.kit.advance(0.05);
    assertThat(world.objects()).isEmpty(); // waits for a state that is newer
    world.kit.publish(Channels.STATE, local(1.0, 0.0, 0.0)); // at 0.1 s: 10 m/s
    world.kit.advance(0.1);

    assertThat(world.objects().get(0).x()).isCloseTo(5.5, within(1e-6));
  }

  @Test
  void objects_walker_isAMovingSphereWithItsWay() {
    world.kit.with("MODELLERS", "OBJECTS").with("DEFAULT SIGMA", 0.1).start(WorldModeler::new);
    for (int i = 0; i <= 30; i++) {
      world.tick(local(0.0, 0.0, 0.0), seen("w", 5.0, -2.0 + 0.15 * i));
    }

    MovingSphere walker = (MovingSphere) world.objects().get(0);
    assertThat(walker.motion().velocity().orElseThrow().distanceTo(Point.of(0.0, -1.5, 0.0)))
        .isLessThan(0.3);
    assertThat(walker.radius()).isCloseTo(1.2, within(1e-9)); // its own 0.2 m and BUFFER
    assertThat(walker.trajectory()).hasSize(10);
    assertThat(walker.center().distanceTo(Point.of(5.0, -2.65, 0.0))).isLessThan(0.3);
  }

  @Test
  void objects_goneFromTheFieldOfView_areDropped() {
    world.kit.with("MODELLERS", "OBJECTS").with("FIELDS OF VIEW", "Camera: 90 deg, 10 m");
    world.kit.start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      world.tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 0.0), seen("b", 5.0, 3.0));
    }
    assertThat(world.objects()).hasSize(2);
    for (int i = 0; i < 6; i++) {
      world.tick(local(0.0, 0.0, Math.PI), seen("c", 6.0, 0.0)); // looks the other way: no say
    }
    assertThat(world.objects()).hasSize(3);
    for (int i = 0; i < 6; i++) {
      world.tick(local(0.0, 0.0, 0.0), seen("b", 5.0, 3.0));
    }
    assertThat(world.objects())
        .extracting(ObjectDescription::uid)
        .containsExactlyInAnyOrder("b", "c");
  }

  @Test
  void fieldsOfView_misspeltSensor_isNamedInHealth() {
    world
        .kit
        .with("MODELLERS", "OBJECTS")
        .with("FIELDS OF VIEW", "Camera: 9 deg, 1 m; Cam: 9 deg, 1 m");
    world.kit.start(WorldModeler::new);
    world.tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 0.0));
    world.tick(local(0.0, 0.0, 0.0));
    world.kit.advance(1.0);
    assertThat(world.remarks())
        .contains("no sightings from [Cam] in FIELDS OF VIEW, only from [Camera]");
  }

  @Test
  void objects_goneFromTheFieldOfViewOfAScanner_areDropped() {
    world.kit.with("MODELLERS", "OBJECTS").with("FIELDS OF VIEW", "Lidar: 90 deg, 10 m");
    world.kit.start(WorldModeler::new);
    String source = "Lidar" + SensorParts.OBJECTS;
    for (int i = 0; i < 5; i++) {
      world.tick(
          local(0.0, 0.0, 0.0),
          seen("a", 5.0, 0.0).sensorName(source),
          seen("b", 5.0, 3.0).sensorName(source));
    }
    for (int i = 0; i < 6; i++) {
      world.tick(local(0.0, 0.0, 0.0), seen("b", 5.0, 3.0).sensorName(source));
    }
    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("b");
  }

  @Test
  void objects_scanThroughTheirPlace_areDropped() {
    world.kit.with("MODELLERS", "OBJECTS").with("SCANNERS SEE", "barrel").start(WorldModeler::new);
    for (int i = 0; i < 4; i++) {
      world.tick(local(0.0, 0.0, 0.0), seen("a", 5.0, 0.0));
    }
    for (int i = 0; i < 8; i++) {
      world.kit.send(Channels.SCANS, wallAhead(5.0));
      world.tick(local(0.0, 0.0, 0.0));
    }
    assertThat(world.objects()).hasSize(1); // an echo where it is
    for (int i = 0; i < 8; i++) {
      world.kit.send(Channels.SCANS, wallAhead(8.0));
      world.tick(local(0.0, 0.0, 0.0));
    }
    assertThat(world.objects()).isEmpty();
  }

  /** A detector's sighting with errors of 0.1 m, of one who is this far to the left. */
  private ObjectDescription walker(double left) {
    return seen("w", 5.0 + 0.1 * errors.nextGaussian(), left + 0.1 * errors.nextGaussian());
  }

  private void walks(int ticks, double fromLeft, double mps) {
    for (int i = 1; i <= ticks; i++) {
      world.tick(local(0.0, 0.0, 0.0), walker(fromLeft + 0.1 * i * mps));
    }
  }

  @Test
  void objects_slowWalkerSeenWithErrors_isKnownToMoveAndHowFast() {
    world.kit.with("MODELLERS", "OBJECTS").with("DEFAULT SIGMA", 0.1).start(WorldModeler::new);
    walks(40, 0.0, 0.3);
    int moving = 0;
    for (int i = 1; i <= 40; i++) {
      walks(1, 1.2 + 0.03 * (i - 1), 0.3);
      if (world.objects().get(0) instanceof MovingSphere) {
        moving++;
        Point velocity = world.objects().get(0).motion().velocity().orElseThrow();
        assertThat(velocity.distanceTo(Point.of(0.0, -0.3, 0.0))).isLessThan(0.25);
      }
    }
    assertThat(moving).isGreaterThan(35);
  }

  @Test
  void objects_walkerOutOfSight_walksOnAndIsDroppedAfterForgetMoving() {
    world.kit.with("MODELLERS", "OBJECTS").with("DEFAULT SIGMA", 0.1).start(WorldModeler::new);
    walks(60, 0.0, 0.5);
    world.stand(30);
    assertThat(world.objects().get(0)).isInstanceOf(MovingSphere.class);
    assertThat(world.objects().get(0).y()).isCloseTo(-4.5, within(0.7));
    world.stand(30);
    assertThat(world.objects()).isEmpty();
  }

  @Test
  void objects_walkerStops_saysThatItStandsAndStaysThere() {
    world.kit.with("MODELLERS", "OBJECTS").with("DEFAULT SIGMA", 0.1).start(WorldModeler::new);
    walks(60, 0.0, 0.5);
    walks(40, 3.0, 0.0);
    ObjectDescription stands = world.objects().get(0);
    assertThat(stands).isInstanceOf(Circle.class);
    assertThat(stands.motion().velocity()).contains(Point.ORIGIN);
    world.stand(100);
    assertThat(world.objects().get(0).y()).isCloseTo(-3.0, within(0.2));
  }
}
