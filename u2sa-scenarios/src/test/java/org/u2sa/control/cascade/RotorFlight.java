package org.u2sa.control.cascade;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.u2sa.control.ControlSystem;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.flight.LandingLeg;
import org.u2sa.sim.flight.MassProperties;
import org.u2sa.sim.flight.Rotor;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.ServiceKit;

/** A multirotor of 2 kg: a service for each rotor, and AllocatingControl, in lockstep. */
final class RotorFlight implements AutoCloseable {
  static final double STANDS_M = 0.15;

  private static final double STEP_S = 0.02;
  private static final double MASS_KG = 2.0;
  private static final Point INERTIA = Point.of(0.022, 0.022, 0.04);
  private static final double ARM_M = 0.275;
  private static final double THRUST = 1.2e-5; // N s²
  private static final double TORQUE = 2.0e-7; // N m s²
  private static final double MAX_RADPS = 950.0;

  final ServiceKit kit = new ServiceKit();
  final UnmannedAircraft aircraft;
  final List<VehicleTruth> track = new ArrayList<>();
  private final VehicleRun run;
  private ControlSystem control;
  Point target = Point.of(0.0, 0.0, -STANDS_M); // north, east, down [m]
  boolean isCutOff; // by a pilot's multiplexer: the rotors keep their thrust
  double velocityErrorMps; // amplitude of a slow error of the measured velocity

  RotorFlight(int rotors, Wind wind) {
    this(IntStream.range(0, rotors).map(i -> i % 2 == 0 ? 1 : -1).toArray(), wind);
  }

  /**
   * @param spins 1 or −1 of each rotor, clockwise from ahead to the right
   */
  RotorFlight(int[] spins, Wind wind) {
    int rotors = spins.length;
    World world = World.at(new Geodetic(9.0, 54.0, 0.0)).with(wind);
    List<Rotor> all = new ArrayList<>();
    for (int i = 0; i < rotors; i++) {
      double bearing = 2.0 * Math.PI * (i + 0.5) / rotors;
      Point hub = Point.of(ARM_M * Math.cos(bearing), ARM_M * Math.sin(bearing), -0.05);
      all.add(rotor("ROTOR " + (i + 1), hub, spins[i]));
    }
    aircraft =
        UnmannedAircraft.multirotor(
            new MassProperties(MASS_KG, INERTIA, 0.0),
            all,
            Point.of(0.03, 0.03, 0.05),
            List.of(leg(0.15, 0.15), leg(0.15, -0.15), leg(-0.15, 0.15), leg(-0.15, -0.15)),
            Footprint.rectangle(0.4, 0.4, 0.8, -STANDS_M, 0.1),
            world,
            Point.of(0.0, 0.0, STANDS_M),
            0.0);
    run = new VehicleRun(aircraft);
    all.forEach(this::start);
    kit.withoutVariables();
    tuning().forEach(kit::with);
    control = kit.start(AllocatingControl::new);
  }

  private static LandingLeg leg(double x, double y) {
    return LandingLeg.straight(Point.of(x, y, STANDS_M), false);
  }

  private static Rotor rotor(String name, Point hub, int spin) {
    Point up = Point.of(0.0, 0.0, -1.0);
    return new Rotor(name, hub, up, spin, THRUST, TORQUE, 1.5e-4, 3e-4, 3e-3, MAX_RADPS, 0.03);
  }

  private void start(Rotor rotor) {
    double full = rotor.fullThrustN();
    double torque = rotor.torque() * MAX_RADPS * MAX_RADPS;
    Point at = rotor.place();
    kit.withoutVariables();
    kit.with(
        "EFFECT",
        String.format(
            Locale.ROOT,
            "wrench 0 0 %s %s %s %s / 0 0 0 0 0 0",
            -full,
            -at.y() * full,
            at.x() * full,
            -rotor.spin() * torque));
    kit.with("EFFECT EXPONENT", 2.0).with("TIME CONSTANT", rotor.timeConstantS());
    kit.start(context -> new RotorService(context, rotor.name()));
  }

  /** The service of one rotor. */
  private final class RotorService extends Actuator {
    RotorService(ServiceContext context, String name) {
      super(context, name);
    }

    @Override
    protected void actuate(double percentage) {
      if (!isCutOff) {
        run.command(clock().micros(), actuatorName(), Math.max(0.0, percentage / 100.0));
      }
    }

    @Override
    protected void neutral() {
      run.command(clock().micros(), actuatorName(), 0.0);
    }
  }

  static Map<String, Object> tuning() {
    Map<String, Object> tuning = new LinkedHashMap<>();
    tuning.put("LEANS", true);
    tuning.put("MAX LEAN", 35.0);
    tuning.put("CRUISE SPEED", 4.0);
    tuning.put("SURGE GAIN", 1.5);
    tuning.put("SURGE INTEGRAL TIME", 3.0);
    tuning.put("SURGE POSITION GAIN", 0.6);
    tuning.put("SURGE MAX SPEED", 6.0);
    tuning.put("SWAY GAIN", 1.5);
    tuning.put("SWAY INTEGRAL TIME", 3.0);
    tuning.put("SWAY POSITION GAIN", 0.6);
    tuning.put("SWAY MAX SPEED", 6.0);
    tuning.put("HEAVE WEIGHT", 3.0);
    tuning.put("HEAVE MASS", MASS_KG);
    tuning.put("HEAVE GAIN", 3.0);
    tuning.put("HEAVE INTEGRAL TIME", 1.5);
    tuning.put("HEAVE POSITION GAIN", 1.0);
    tuning.put("HEAVE MAX SPEED", 2.0);
    tuning.put("ROLL WEIGHT", 10.0);
    tuning.put("ROLL INERTIA", INERTIA.x());
    tuning.put("ROLL GAIN", 12.0);
    tuning.put("ROLL INTEGRAL TIME", 1.0);
    tuning.put("ROLL ANGLE GAIN", 5.0);
    tuning.put("ROLL MAX RATE", 200.0);
    tuning.put("PITCH WEIGHT", 10.0);
    tuning.put("PITCH INERTIA", INERTIA.y());
    tuning.put("PITCH GAIN", 12.0);
    tuning.put("PITCH INTEGRAL TIME", 1.0);
    tuning.put("PITCH ANGLE GAIN", 5.0);
    tuning.put("PITCH MAX RATE", 200.0);
    tuning.put("YAW WEIGHT", 1.0);
    tuning.put("YAW INERTIA", INERTIA.z());
    tuning.put("YAW GAIN", 3.0);
    tuning.put("YAW INTEGRAL TIME", 2.0);
    tuning.put("YAW ANGLE GAIN", 1.5);
    tuning.put("YAW MAX RATE", 60.0);
    return tuning;
  }

  void swap() {
    kit.withoutVariables();
    tuning().forEach(kit::with);
    control = kit.swap(control, AllocatingControl::new);
  }

  /** Another control takes over, which gives each rotor the same share [%] without feedback. */
  void flyBlind(double percentage, double seconds) {
    kit.withoutVariables();
    ControlSystem blind = kit.swap(control, context -> new BlindControl(context, percentage));
    fly(seconds);
    kit.withoutVariables();
    tuning().forEach(kit::with);
    control = kit.swap(blind, AllocatingControl::new);
  }

  /** A control that lets the aircraft sink or rise. */
  private final class BlindControl extends ControlSystem {
    private final double percentage;

    BlindControl(ServiceContext context, double percentage) {
      super(context, "Control");
      this.percentage = percentage;
    }

    @Override
    protected void control(StateInformation state, Optional<NavigationPoint> point) {
      aircraft.actuators().forEach(rotor -> command(rotor, percentage));
    }

    @Override
    protected Map<String, Double> neutral() {
      return Map.of();
    }
  }

  void fly(double seconds) {
    for (double end = kit.nowS() + seconds - 1e-9; kit.nowS() < end; ) {
      step(true);
    }
  }

  /** Flies on without navigation points. */
  void flyUntold(double seconds) {
    for (double end = kit.nowS() + seconds - 1e-9; kit.nowS() < end; ) {
      step(false);
    }
  }

  private void step(boolean told) {
    VehicleTruth truth = run.at(kit.clock().micros());
    track.add(truth);
    Point rates = truth.attitude().eulerRates(truth.rates());
    double errorMps = velocityErrorMps * Math.sin(2.0 * kit.nowS());
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(truth.position().y())
            .y(truth.position().x())
            .z(-truth.position().z())
            .xDot(truth.velocity().y() + errorMps)
            .yDot(truth.velocity().x() - errorMps)
            .zDot(-truth.velocity().z() + errorMps)
            .phi(signed(truth.attitude().phi()))
            .theta(truth.attitude().theta())
            .psi(truth.attitude().psi())
            .phiDot(rates.x())
            .thetaDot(rates.y())
            .psiDot(rates.z());
    if (told) {
      NavigationPoint point = NavigationPoint.at(truth.attitude().bodyOf(target.minus(ned(truth))));
      point.timestamp(kit.clock().micros());
      kit.send(Channels.NAVIGATION, point);
    }
    kit.publish(Channels.STATE, state);
    kit.advance(STEP_S);
  }

  private static double signed(double rad) {
    return Math.IEEEremainder(rad, 2.0 * Math.PI);
  }

  private static Point ned(VehicleTruth truth) {
    return Point.of(truth.position().y(), truth.position().x(), -truth.position().z());
  }

  /** Lowest height in the last seconds [m]. */
  double lowestM(double lastS) {
    return lately(lastS).mapToDouble(each -> each.position().z()).min().orElseThrow();
  }

  /** Largest distance from the target in the last seconds [m]. */
  double worstM(double lastS) {
    return lately(lastS).mapToDouble(each -> target.distanceTo(ned(each))).max().orElseThrow();
  }

  /** Largest angle from the vertical in the last seconds [deg]. */
  double steepestDeg(double lastS) {
    return lately(lastS)
        .mapToDouble(
            each ->
                Math.toDegrees(
                    Math.acos(Math.cos(each.attitude().phi()) * Math.cos(each.attitude().theta()))))
        .max()
        .orElseThrow();
  }

  /** Highest speed in the last seconds [m/s]. */
  double fastestMps(double lastS) {
    return lately(lastS).mapToDouble(each -> each.velocity().distance()).max().orElseThrow();
  }

  private Stream<VehicleTruth> lately(double lastS) {
    int count = (int) Math.round(lastS / STEP_S);
    return track.subList(track.size() - count, track.size()).stream();
  }

  @Override
  public void close() {
    kit.close();
  }
}
