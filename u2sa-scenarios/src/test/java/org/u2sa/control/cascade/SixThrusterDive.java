package org.u2sa.control.cascade;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.u2sa.control.ControlSystem;
import org.u2sa.device.ThrusterActuator;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.marine.BlueRov2;
import org.u2sa.sim.marine.VesselThruster;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.ServiceKit;

/** A BlueROV2 in a current: a service for each thruster, and AllocatingControl, in lockstep. */
final class SixThrusterDive implements AutoCloseable {
  static final double STEP_S = 0.05;
  static final Point START = Point.of(0.0, 0.0, -10.0); // east, north, up [m]

  final ServiceKit kit = new ServiceKit();
  final VehicleRun run;
  final Map<String, SimulatedThruster> thrusters = new LinkedHashMap<>();
  final List<VehicleTruth> track = new ArrayList<>();
  private final Map<String, Integer> elsewhere = new LinkedHashMap<>(); // steps since started
  ControlSystem control;
  Point target = Point.of(0.0, 0.0, 10.0); // north, east, down [m]

  SixThrusterDive(double currentEast, double currentNorth) {
    World world =
        World.at(new Geodetic(9.0, 54.0, 0.0)).with(new Water(0.0, currentEast, currentNorth));
    run = new VehicleRun(BlueRov2.at(world, START, 0.0));
    for (VesselThruster each : BlueRov2.thrusters()) {
      start(each);
    }
    kit.withoutVariables();
    tuning().forEach(kit::with);
    control = kit.start(AllocatingControl::new);
  }

  /** Makes a thruster the matter of another process, which may die without a word. */
  void moveToAnotherProcess(String thruster) {
    thrusters.remove(thruster).kill();
    elsewhere.put(thruster, 0);
  }

  /** The other process dies; its thruster goes on as it was told last, or is off. */
  void dies(String thruster, boolean goesOn) {
    elsewhere.remove(thruster);
    if (!goesOn) {
      run.command(kit.clock().micros(), thruster, 0.0);
    }
  }

  private void actElsewhere() {
    for (Map.Entry<String, Integer> each : elsewhere.entrySet()) {
      String name = each.getKey();
      if (each.setValue(each.getValue() + 1) % 5 == 0) {
        ActuatorAnnouncement announcement =
            kit.published(Channels.ACTUATORS).stream()
                .filter(one -> one.actuatorName().equals(name))
                .findFirst()
                .orElseThrow();
        ActuatorAnnouncement renewed = (ActuatorAnnouncement) announcement.copy();
        renewed.serviceName("Elsewhere").timestamp(kit.clock().micros());
        kit.send(Channels.ACTUATORS, renewed);
      }
      run.command(kit.clock().micros(), name, kit.percent(name) / 100.0);
    }
  }

  void start(VesselThruster thruster) {
    kit.withoutVariables();
    Point at = thruster.place();
    Point to = thruster.direction();
    kit.with(
        "EFFECT",
        String.format(
            Locale.ROOT,
            "thrust %s / %s at %s %s %s towards %s %s %s",
            thruster.forwardN(),
            thruster.reverseN(),
            at.x(),
            at.y(),
            at.z(),
            to.x(),
            to.y(),
            to.z()));
    kit.with("EFFECT EXPONENT", thruster.exponent()).with("DEADBAND", 100 * thruster.deadband());
    kit.with("TIME CONSTANT", thruster.timeConstantS());
    String name = thruster.name();
    thrusters.put(name, kit.start(context -> new SimulatedThruster(context, name, run)));
  }

  /** Puts a ThrusterActuator over a propeller that measures its speed in a thruster's place. */
  ThrusterActuator startMeasuring(VesselThruster thruster, VesselPropeller propeller) {
    SimulatedThruster before = thrusters.remove(thruster.name());
    if (before != null) {
      before.kill();
    }
    kit.withoutVariables();
    measuring(thruster).forEach(kit::with);
    return kit.start(context -> new ThrusterActuator(context, propeller));
  }

  /** How a ThrusterActuator is configured for a horizontal thruster. */
  static Map<String, Object> measuring(VesselThruster thruster) {
    Point at = thruster.place();
    Point to = thruster.direction();
    Map<String, Object> variables = new LinkedHashMap<>();
    variables.put("SERVICE NAME", thruster.name());
    variables.put("FULL THRUST", thruster.forwardN());
    variables.put("REVERSE THRUST", thruster.reverseN());
    variables.put("DEADBAND", 100 * thruster.deadband());
    variables.put("MOUNTED X", at.x());
    variables.put("MOUNTED Y", -at.y()); // BODY: to the left
    variables.put("MOUNTED Z", at.z());
    variables.put("MOUNTED PITCH", to.z() > 0.5 ? -Math.PI / 2.0 : 0.0);
    variables.put("MOUNTED YAW", Math.atan2(-to.y(), to.x()));
    return variables;
  }

  static Map<String, Object> tuning() {
    Map<String, Object> tuning = new LinkedHashMap<>();
    tuning.put("SURGE WEIGHT", 1.0);
    tuning.put("SURGE MASS", 17.0);
    tuning.put("SURGE GAIN", 2.0);
    tuning.put("SWAY WEIGHT", 1.0);
    tuning.put("SWAY MASS", 24.0);
    tuning.put("SWAY GAIN", 2.0);
    tuning.put("HEAVE WEIGHT", 1.0);
    tuning.put("HEAVE MASS", 26.0);
    tuning.put("HEAVE GAIN", 2.0);
    tuning.put("YAW WEIGHT", 3.0);
    tuning.put("YAW INERTIA", 0.28);
    tuning.put("YAW GAIN", 6.0);
    tuning.put("YAW INTEGRAL TIME", 1.0);
    tuning.put("YAW ANGLE GAIN", 2.0);
    tuning.put("ESSENTIAL", "YAW");
    tuning.put("WATCHES RESPONSE", true);
    return tuning;
  }

  /** Puts another control of the same configuration in the place of the one that dives. */
  void swap() {
    kit.withoutVariables();
    tuning().forEach(kit::with);
    control = kit.swap(control, AllocatingControl::new);
  }

  /** What the thrusters are commanded now [%]. */
  double[] percents() {
    return thrusters.keySet().stream().mapToDouble(kit::percent).toArray();
  }

  void dive(double seconds) {
    for (double end = kit.nowS() + seconds - 1e-9; kit.nowS() < end; ) {
      step();
    }
  }

  private void step() {
    VehicleTruth truth = run.at(kit.clock().micros());
    track.add(truth);
    Point rates = truth.attitude().eulerRates(truth.rates());
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(truth.position().y())
            .y(truth.position().x())
            .z(-truth.position().z())
            .xDot(truth.velocity().y())
            .yDot(truth.velocity().x())
            .zDot(-truth.velocity().z())
            .phi(truth.attitude().phi())
            .theta(truth.attitude().theta())
            .psi(truth.attitude().psi())
            .phiDot(rates.x())
            .thetaDot(rates.y())
            .psiDot(rates.z());
    Point way =
        target.minus(
            Point.of(state.x().orElseThrow(), state.y().orElseThrow(), state.z().orElseThrow()));
    NavigationPoint point = NavigationPoint.at(truth.attitude().bodyOf(way));
    point.timestamp(kit.clock().micros());
    kit.send(Channels.NAVIGATION, point);
    kit.publish(Channels.STATE, state);
    actElsewhere();
    kit.advance(STEP_S);
  }

  /** Largest distance from the target in the last seconds [m]. */
  double worstM(double lastS) {
    double worst = 0.0;
    int count = (int) Math.round(lastS / STEP_S);
    for (VehicleTruth each : track.subList(track.size() - count, track.size())) {
      Point p = each.position();
      worst = Math.max(worst, target.distanceTo(Point.of(p.y(), p.x(), -p.z())));
    }
    return worst;
  }

  /** Largest error of the heading in the last seconds [deg]. */
  double worstHeadingDeg(double wantedDeg, double lastS) {
    int count = (int) Math.round(lastS / STEP_S);
    return track.subList(track.size() - count, track.size()).stream()
        .mapToDouble(
            each ->
                Math.abs(
                    Math.IEEEremainder(Math.toDegrees(each.attitude().psi()) - wantedDeg, 360.0)))
        .max()
        .orElseThrow();
  }

  /** What the control's health says last. */
  String health() {
    return kit.published(Channels.HEALTH).stream()
        .filter(report -> report.serviceName().equals("Control"))
        .map(HealthReport::lastError)
        .reduce((first, second) -> second)
        .flatMap(error -> error)
        .orElse("");
  }

  /** Time at which a thruster was commanded something else than 0 last [s]. */
  double lastDrivenS(String thruster) {
    return kit.published(Channels.ACTUATION).stream()
        .filter(command -> command.actuatorName().equals(thruster))
        .filter(command -> !command.toString().contains("percentage=0.0"))
        .mapToDouble(command -> command.timestamp().orElseThrow() / 1e6)
        .max()
        .orElse(0.0);
  }

  @Override
  public void close() {
    kit.close();
  }
}
