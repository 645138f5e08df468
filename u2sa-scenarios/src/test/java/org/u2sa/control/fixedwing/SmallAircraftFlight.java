package org.u2sa.control.fixedwing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.ServiceKit;

/** A small fixed-wing aircraft, thrown by a catapult, by CessnaControl with its own gains. */
final class SmallAircraftFlight implements AutoCloseable {
  static final double STEP_S = 0.02;

  final ServiceKit kit = new ServiceKit();
  final List<VehicleTruth> track = new ArrayList<>();
  final UnmannedAircraft aircraft;
  private final VehicleRun run;
  private final Map<String, Object> tuning;
  private CessnaControl control;
  private final Set<String> inverted; // actuators whose positive command deflects to the negative

  /**
   * @param inverted actuators that the aircraft takes with the opposite sign
   */
  SmallAircraftFlight(UnmannedAircraft aircraft, Set<String> inverted, Map<String, Object> tuning) {
    this.aircraft = aircraft;
    this.inverted = inverted;
    run = new VehicleRun(aircraft);
    kit.withoutVariables();
    for (String name : aircraft.actuators()) {
      kit.start(context -> new ActuatorService(context, name));
    }
    this.tuning = tuning;
    tuning.forEach(kit::with);
    control = kit.start(CessnaControl::new);
  }

  /** The service of one actuator. */
  private final class ActuatorService extends Actuator {
    ActuatorService(ServiceContext context, String name) {
      super(context, name);
    }

    @Override
    protected void actuate(double percentage) {
      double share = percentage / 100.0;
      run.command(
          clock().micros(), actuatorName(), inverted.contains(actuatorName()) ? -share : share);
    }

    @Override
    protected void neutral() {
      run.command(clock().micros(), actuatorName(), 0.0);
    }
  }

  /**
   * A pilot flies, then returns control.
   *
   * @param percentages of the actuators
   */
  void flyByHand(Point place, double seconds, Map<String, Double> percentages) {
    for (double end = kit.nowS() + seconds - 1e-9; kit.nowS() < end; ) {
      byHand(true);
      percentages.forEach(
          (actuator, percentage) ->
              kit.send(Channels.ACTUATION, PercentageCommand.of(actuator, percentage)));
      step(place);
    }
    byHand(false);
  }

  private void byHand(boolean active) {
    kit.send(Channels.MANUAL_STATE, new ManualState().active(active).operator("ann").takeovers(1L));
  }

  /** The control ends, which leaves the surfaces neutral and the throttle closed, and restarts. */
  void flyWithoutControl(Point place, double seconds) {
    control.shutDown();
    fly(place, seconds);
    kit.withoutVariables();
    tuning.forEach(kit::with);
    control = kit.restart(control, CessnaControl::new);
  }

  /** Flies to a place: east, north, up [m]; true if it passes within a distance. */
  boolean flyTo(Point place, double withinM, double atMostS) {
    for (double end = kit.nowS() + atMostS; kit.nowS() < end; ) {
      VehicleTruth truth = step(place);
      if (truth.position().distanceTo(place) < withinM) {
        return true;
      }
    }
    return false;
  }

  /** Flies towards a place for a time. */
  void fly(Point place, double seconds) {
    for (double end = kit.nowS() + seconds - 1e-9; kit.nowS() < end; ) {
      step(place);
    }
  }

  /** Time passes without states. */
  void flyUnseen(double seconds) {
    for (double end = kit.nowS() + seconds - 1e-9; kit.nowS() < end; ) {
      track.add(run.at(kit.clock().micros()));
      kit.advance(STEP_S);
    }
  }

  /** Newest truth. */
  VehicleTruth now() {
    return track.get(track.size() - 1);
  }

  /** Lowest altitude in the last seconds [m]. */
  double lowestM(double lastS) {
    return lately(lastS).mapToDouble(each -> each.position().z()).min().orElseThrow();
  }

  /** Lowest speed over ground in the last seconds [m/s]. */
  double slowestMps(double lastS) {
    return lately(lastS).mapToDouble(each -> each.velocity().distance()).min().orElseThrow();
  }

  /** Largest upward acceleration over 0.1 s in the last seconds [m/s²]. */
  double hardestPullMps2(double lastS) {
    List<Double> climbs = lately(lastS).map(each -> each.velocity().z()).toList();
    int steps = 5;
    return IntStream.range(steps, climbs.size())
        .mapToDouble(i -> (climbs.get(i) - climbs.get(i - steps)) / (steps * STEP_S))
        .max()
        .orElseThrow();
  }

  private Stream<VehicleTruth> lately(double lastS) {
    int count = (int) Math.round(lastS / STEP_S);
    return track.subList(track.size() - count, track.size()).stream();
  }

  private VehicleTruth step(Point target) {
    VehicleTruth truth = run.at(kit.clock().micros());
    track.add(truth);
    Point rates = truth.attitude().eulerRates(truth.rates());
    Geodetic place =
        aircraft
            .world()
            .plane()
            .at(truth.position().x(), truth.position().y(), truth.position().z());
    Point through = aircraft.throughAir();
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.GLOBAL)
            .x(place.longitudeDeg())
            .y(place.latitudeDeg())
            .z(place.altitudeM())
            .xDot(truth.velocity().x())
            .yDot(truth.velocity().y())
            .zDot(truth.velocity().z())
            .phi(Math.IEEEremainder(truth.attitude().phi(), 2.0 * Math.PI))
            .theta(truth.attitude().theta())
            .psi(truth.attitude().psi())
            .phiDot(rates.x())
            .thetaDot(rates.y())
            .psiDot(rates.z())
            .fluidxDot(through.x())
            .fluidyDot(-through.y())
            .fluidzDot(through.z());
    Point enu = target.minus(truth.position());
    Point ned = Point.of(enu.y(), enu.x(), -enu.z());
    NavigationPoint point = NavigationPoint.at(truth.attitude().bodyOf(ned));
    point.timestamp(kit.clock().micros());
    kit.send(Channels.NAVIGATION, point);
    kit.publish(Channels.STATE, state);
    kit.advance(STEP_S);
    return truth;
  }

  /** Gains of the Aerosonde: 11 kg, 2.9 m of span, 25 m/s. */
  static Map<String, Object> aerosonde() {
    Map<String, Object> tuning = new LinkedHashMap<>();
    tuning.put("CRUISE SPEED", 25.0);
    tuning.put("MAX SPEED", 35.0);
    tuning.put("REFERENCE SPEED", 25.0);
    tuning.put("STALL SPEED", 14.0);
    tuning.put("STALL BAND", 2.0);
    tuning.put("BANK LIMIT", 40.0);
    tuning.put("BANK RATE LIMIT", 40.0);
    tuning.put("MIN LOOK AHEAD", 60.0);
    tuning.put("MIN SPEED", 10.0);
    tuning.put("TURN PITCH", 3.0);
    tuning.put("THROTTLE TRIM", 0.67);
    tuning.put("ROLL RATE LIMIT", 60.0);
    tuning.put("BANK TIME CONSTANT", 0.5);
    tuning.put("ROLL RATE FORWARD GAIN", 0.35);
    tuning.put("ROLL RATE GAIN", 0.15);
    tuning.put("ROLL RATE INTEGRAL GAIN", 0.2);
    tuning.put("PITCH TIME CONSTANT", 0.5);
    tuning.put("PITCH RATE LIMIT", 20.0);
    tuning.put("PITCH RATE FORWARD GAIN", 0.3);
    tuning.put("PITCH RATE GAIN", 0.2);
    tuning.put("PITCH RATE INTEGRAL GAIN", 1.0);
    tuning.put("YAW DAMPING", 0.2);
    tuning.put("SIDESLIP GAIN", 0.5);
    tuning.put("AILERON TO RUDDER", 0.0);
    return tuning;
  }

  @Override
  public void close() {
    kit.close();
  }
}
