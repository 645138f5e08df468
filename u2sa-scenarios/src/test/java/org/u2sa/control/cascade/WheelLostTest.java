package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.ServiceKit;

/**
 * Actuator lost in mid-mission, differential: the Mini-Molle, wheels allocated by announcements.
 */
class WheelLostTest {
  private static final double STEP_S = 0.05;

  private final ServiceKit kit = new ServiceKit();
  private final VehicleRun run =
      new VehicleRun(new DifferentialVehicle(DifferentialParameters.miniMolle()));
  private final Map<String, SimulatedThruster> wheels = new LinkedHashMap<>();
  private final List<VehicleTruth> track = new ArrayList<>();

  @AfterEach
  void end() {
    kit.close();
  }

  private void start() {
    start("SURGE YAW");
  }

  private void start(String essential) {
    List<String> names = run.vehicle().actuators();
    wheel(names.get(0), "thrust 40 at 0 -0.22 0 towards 1 0 0");
    wheel(names.get(1), "thrust 40 at 0 0.22 0 towards 1 0 0");
    kit.withoutVariables();
    kit.with("SURGE WEIGHT", 1.0).with("SURGE MASS", 12.0).with("SURGE GAIN", 2.0);
    kit.with("SURGE INTEGRAL TIME", 1.5).with("SURGE POSITION GAIN", 0.5);
    kit.with("SURGE MAX SPEED", 0.8).with("CRUISE SPEED", 0.8);
    kit.with("YAW WEIGHT", 3.0).with("YAW INERTIA", 1.0).with("YAW GAIN", 5.0);
    kit.with("YAW INTEGRAL TIME", 1.0).with("YAW ANGLE GAIN", 1.5).with("YAW MAX RATE", 60.0);
    kit.with("FACES THE WAY", true).with("FACING DISTANCE", 0.3);
    kit.with("ESSENTIAL", essential);
    kit.start(AllocatingControl::new);
  }

  private void wheel(String name, String effect) {
    kit.withoutVariables().with("EFFECT", effect);
    wheels.put(name, kit.start(context -> new SimulatedThruster(context, name, run)));
  }

  private double drive(Point target, double seconds) {
    double nearest = Double.POSITIVE_INFINITY;
    for (double end = kit.nowS() + seconds - 1e-9; kit.nowS() < end; ) {
      VehicleTruth truth = run.at(kit.clock().micros());
      track.add(truth);
      StateInformation state =
          new StateInformation()
              .referenceFrame(ReferenceFrame.LOCAL_NED)
              .x(truth.position().y())
              .y(truth.position().x())
              .xDot(truth.velocity().y())
              .yDot(truth.velocity().x())
              .psi(truth.headingRad())
              .psiDot(truth.rates().z());
      Point way = target.minus(Point.of(truth.position().y(), truth.position().x(), 0.0));
      nearest = Math.min(nearest, way.distance());
      NavigationPoint point = NavigationPoint.at(truth.attitude().bodyOf(way));
      point.timestamp(kit.clock().micros());
      kit.send(Channels.NAVIGATION, point);
      kit.publish(Channels.STATE, state);
      kit.advance(STEP_S);
    }
    return nearest;
  }

  private String health() {
    return kit.published(Channels.HEALTH).stream()
        .filter(report -> report.serviceName().equals("Control"))
        .map(HealthReport::lastError)
        .reduce((first, second) -> second)
        .flatMap(error -> error)
        .orElse("");
  }

  @Test
  void drive_bothWheels_reachesTheCorners() {
    start();

    assertThat(drive(Point.of(6.0, 0.0, 0.0), 20.0)).isLessThan(0.3);
    assertThat(drive(Point.of(6.0, 6.0, 0.0), 20.0)).isLessThan(0.3);
    assertThat(health()).isEmpty();
  }

  @Test
  void drive_oneWheelWeakened_stillReachesTheCorner() {
    start();
    drive(Point.of(6.0, 0.0, 0.0), 5.0);
    wheels.get(run.vehicle().actuators().get(1)).derate(60.0);

    assertThat(drive(Point.of(6.0, 0.0, 0.0), 20.0)).isLessThan(0.3);
    assertThat(drive(Point.of(6.0, 6.0, 0.0), 25.0)).isLessThan(0.3);
    assertThat(health()).isEqualTo("authority left: surge 60 %, yaw 60 %");
  }

  /** With one wheel, driving is turning: it stops where it is, and says why. */
  @ParameterizedTest
  @CsvSource({"SURGE YAW, actuators are neutral", "'', horizontal thrust is off"})
  void drive_oneWheelLost_stopsAtOnceAndSaysWhatCannotBeControlled(String essential, String words) {
    start(essential);
    drive(Point.of(20.0, 0.0, 0.0), 8.0);
    VehicleTruth before = run.at(kit.clock().micros());
    assertThat(before.speedMps()).isGreaterThan(0.5);
    wheels.get(run.vehicle().actuators().get(0)).kill();

    drive(Point.of(20.0, 0.0, 0.0), 10.0);

    VehicleTruth after = run.at(kit.clock().micros());
    assertThat(after.speedMps()).isLessThan(0.01);
    assertThat(after.position().distanceTo(before.position())).isLessThan(1.0);
    assertThat(Math.abs(Math.IEEEremainder(after.headingRad() - before.headingRad(), 2 * Math.PI)))
        .isLessThan(Math.toRadians(30.0));
    assertThat(health()).startsWith("lost: ").endsWith("cannot control surge, yaw; " + words);
  }
}
