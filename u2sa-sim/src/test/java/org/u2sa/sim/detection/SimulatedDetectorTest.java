package org.u2sa.sim.detection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.device.detection.ObjectDetector.Detection;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.PathMarker;
import org.u2sa.messages.shape.Box;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

/** A detector 1 m above the origin that looks north: 90 degrees wide, 30 m far, 5 m into water. */
class SimulatedDetectorTest {
  private static final SimulatedDetector.Optics EXACT =
      new SimulatedDetector.Optics(30.0, 5.0, Math.PI / 2.0, Math.PI / 2.0, 0.0, 0.0, 0.0);

  private static ObjectDescription buoy(double east, double north, double up) {
    ObjectDescription buoy =
        new Buoy()
            .colour(Colour.RED)
            .radius(0.2)
            .uid("buoy")
            .objectType("red buoy")
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(east)
            .y(north)
            .z(up);
    buoy.freeze();
    return buoy;
  }

  private static List<Detection> seen(
      SimulatedDetector.Optics optics, long seed, ObjectDescription... objects) {
    VehicleTruth truth =
        new VehicleTruth(
            0.0,
            Point.of(0.0, 0.0, 1.0),
            new Attitude(0.0, 0.0, 0.0),
            Point.ORIGIN,
            Point.ORIGIN,
            Point.ORIGIN);
    World world =
        World.at(new Geodetic(10.0, 54.0, 0.0))
            .with(List.of(objects))
            .with(new Water(0.0, 0.0, 0.0));
    SimulatedDetector detector =
        new SimulatedDetector(
            new SensorErrors(10.0, 0.0, 0.0, 0.0, 0.0),
            optics,
            new NoiseStreams(seed),
            world,
            () -> truth);
    return detector.read(0L).orElseThrow().detections();
  }

  @Test
  void read_buoyAheadToTheRight_hasNegativeBearingAndItsDistance() {
    Detection seen = seen(EXACT, 1, buoy(5.0, 10.0, 1.0)).get(0);

    assertThat(seen.label()).isEqualTo("red buoy");
    assertThat(seen.bearingRad()).isCloseTo(-Math.atan2(5.0, 10.0), within(1e-9));
    assertThat(seen.elevationRad()).isCloseTo(0.0, within(1e-9));
    assertThat(seen.rangeM()).isCloseTo(Math.hypot(5.0, 10.0), within(1e-9));
    assertThat(seen.radiusM()).isEqualTo(0.2);
  }

  @Test
  void read_pathMarker_hasTheDirectionOfItsLength() {
    ObjectDescription marker = new PathMarker().length(1.2).width(0.15).psi(Math.PI / 6.0);
    marker
        .uid("marker")
        .objectType("path marker")
        .referenceFrame(ReferenceFrame.LOCAL_ENU)
        .x(0.0)
        .y(3.0)
        .z(0.0);
    marker.freeze();

    Point axis = seen(EXACT, 1, marker).get(0).axis().orElseThrow(); // forward is north
    assertThat(axis.x()).isCloseTo(0.5, within(1e-9));
    assertThat(axis.y()).as("to the left").isCloseTo(-Math.cos(Math.PI / 6.0), within(1e-9));
    assertThat(axis.z()).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void read_dock_hasHalfItsWidth() {
    ObjectDescription dock = new Dock().length(1.5).width(3.2).height(0.5).thickness(0.2);
    dock.uid("dock").objectType("dock").referenceFrame(ReferenceFrame.LOCAL_ENU);
    dock.x(0.0).y(10.0).z(1.0);
    dock.freeze();

    assertThat(seen(EXACT, 1, dock).get(0).radiusM()).isEqualTo(1.6);
  }

  @Test
  void read_outsideTheViewOrTooFar_isNotSeen() {
    assertThat(seen(EXACT, 1, buoy(10.0, 5.0, 1.0))).as("beside").isEmpty();
    assertThat(seen(EXACT, 1, buoy(0.0, -5.0, 1.0))).as("behind").isEmpty();
    assertThat(seen(EXACT, 1, buoy(0.0, 31.0, 1.0))).as("beyond its reach").isEmpty();
  }

  @Test
  void read_underWater_isSeenFromNearOnly() {
    assertThat(seen(EXACT, 1, buoy(0.0, 4.0, -0.5))).hasSize(1);
    assertThat(seen(EXACT, 1, buoy(0.0, 8.0, -0.5))).isEmpty();
  }

  @Test
  void read_behindAWall_isHidden() {
    Box wall = new Box().length(1.0).width(10.0).height(4.0).psi(Math.PI / 2.0);
    wall.uid("wall").objectType("").referenceFrame(ReferenceFrame.LOCAL_ENU);
    wall.x(0.0).y(5.0).z(1.0);
    wall.freeze();

    assertThat(seen(EXACT, 1, buoy(0.0, 10.0, 1.0), wall)).isEmpty();
    assertThat(seen(EXACT, 1, buoy(0.0, 3.0, 1.0), wall)).hasSize(1);
  }

  @Test
  void read_manyPictures_errorsAndMissesAreThoseOfTheOptics() {
    SimulatedDetector.Optics noisy =
        new SimulatedDetector.Optics(30.0, 5.0, Math.PI / 2.0, Math.PI / 2.0, 0.01, 0.05, 0.2);
    int found = 0;
    double squares = 0.0;
    for (int seed = 0; seed < 1000; seed++) {
      for (Detection each : seen(noisy, seed, buoy(0.0, 10.0, 1.0))) {
        found++;
        squares += Math.pow(each.rangeM() - 10.0, 2);
      }
    }

    assertThat(found).isBetween(750, 850);
    assertThat(Math.sqrt(squares / found)).isCloseTo(0.5, within(0.06));
  }
}
