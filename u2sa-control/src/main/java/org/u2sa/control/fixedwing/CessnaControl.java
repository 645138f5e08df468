package org.u2sa.control.fixedwing;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Supplier;
import org.u2sa.control.ControlSystem;
import org.u2sa.control.LandingGoals;
import org.u2sa.control.Transfer;
import org.u2sa.control.allocation.ActuatorRoster;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * Flies a Cessna 172, or another aeroplane given its gains and speeds, autonomously from the runway
 * along its mission. In: state, navigation, arming-state, goals. Out: actuation (aileron, elevator,
 * rudder, throttle, mixture, flaps, brakes, once per state), control-status, goal-reports (of
 * landings that it cannot fly). Without fresh navigation it holds wings level and altitude, then
 * circles; on the ground it holds the brakes. If navigation leads to the ground, it lands. Disarmed
 * and at rest, it keeps the throttle closed.
 */
public final class CessnaControl extends ControlSystem {
  private static final double STATUS_INTERVAL_S = 1.0;
  private static final double FULL_PERCENT = 100.0;
  private static final long BY_HAND_EXPIRY_MICROS = 2 * Clock.MICROS_PER_SECOND; // four repetitions
  private static final String FIRST_STATE = "FIRST STATE"; // in the hand-over
  private static final double RAISED_FOR_S = 60.0; // an airspeed not raised for so long is usual
  private static final double AT_REST_MPS = 2.0; // over ground

  private record Outputs(
      @Variable(unit = "s", min = 0.02, max = 60, ifAbsent = 10)
          @Description("Lifetime of a throttle, mixture or flap command that is not renewed.")
          double powerExpiry,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether LEFT ELEVON and RIGHT ELEVON take the place of AILERON and ELEVATOR, as on flying wings.")
          boolean elevons) {}

  private final Settings<Outputs> outputs = settings(Outputs.class);
  private final Supplier<AutopilotVariables> tuning = AutopilotVariables.in(this);
  private final FlightStateReader reader =
      new FlightStateReader(settings(GroundReference.Variables.class));
  private final ActuatorRoster roster = new ActuatorRoster();
  private final LandingGoals landings = new LandingGoals();
  private SurfaceMixing mixing = SurfaceMixing.SOUND;
  private Autopilot autopilot;
  private ManualState byHand = new ManualState(); // by the pilot's radio
  private long byHandMicros; // time at which that was last received
  private double firstS = Double.NaN; // time of the first state
  private boolean isArmed = true; // without an arming service, actuators obey immediately
  private boolean isGroundSaved;
  private FlightPhase loggedPhase;
  private boolean loggedNavigating;
  private double raisedS = Double.NaN; // when the wind last raised the airspeed; NaN: told nothing
  private double statusDueS = Double.NEGATIVE_INFINITY;
  private List<String> loggedMissing = List.of();

  public CessnaControl(ServiceContext context) {
    super(context, "Control");
    autopilot = new Autopilot(tuning.get());
    subscribe(Channels.ACTUATORS, announced -> roster.see(announced, clock().micros()));
    subscribe(Channels.MANUAL_STATE, this::onManual);
    subscribe(Channels.ARMING_STATE, state -> isArmed = state.armed());
    subscribe(Channels.GOALS, goals -> landings.see(goals, clock().micros()));
    registerPublisher(ControlStatus.CHANNEL);
    registerPublisher(Channels.GOAL_REPORTS);
  }

  private void onManual(ManualState state) {
    if (state.requestId().isPresent()) {
      return; // this service's own answer
    }
    if (byHand.active() && !state.active()) {
      beginAgain();
    }
    byHand = state;
    byHandMicros = clock().micros();
  }

  /** Restarts the control laws when a pilot has returned control, wherever the aircraft is. */
  private void beginAgain() {
    autopilot = new Autopilot(tuning.get());
    takeOverCommands();
  }

  /**
   * Whether a pilot flies. If the radio's service falls silent, it is unknown who flies; commands
   * do no harm while the multiplexer connects the pilot, but otherwise nobody would fly.
   */
  private boolean isByHand() {
    if (byHand.active() && clock().micros() - byHandMicros > BY_HAND_EXPIRY_MICROS) {
      String why = "no service reports any longer that \"" + byHand.operator() + "\" flies";
      trouble(why + ": in control");
      ManualState ended = new ManualState().active(false).operator(byHand.operator());
      onManual(ended.takeovers(byHand.takeovers()).reason(why));
      publish(Channels.MANUAL_STATE, ended);
    }
    return byHand.active();
  }

  @Override
  protected ManualState byHand(ManualOrder order, Optional<String> late) {
    ManualState refusal = super.byHand(order, late);
    return refusal
        .active(byHand.active())
        .operator(byHand.operator())
        .takeovers(byHand.takeovers());
  }

  /** Applies new gains and limits in flight. */
  @Override
  protected void configurationChanged(Set<String> variableNames) {
    HandOver state = new HandOver(getClass().getName());
    autopilot.transfer(Transfer.saving(state));
    autopilot = new Autopilot(tuning.get());
    autopilot.transfer(Transfer.restoring(state));
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    Optional<FlightState> seen = reader.read(state);
    if (seen.isEmpty()) {
      lacking(reader.missing(state));
      return;
    }
    landings
        .refused(reader.cannotLand(state), clock().micros())
        .ifPresent(report -> publish(Channels.GOAL_REPORTS, report));
    loggedMissing = List.of();
    if (isByHand()) {
      return;
    }
    FlightState now = seen.get();
    Optional<GuidanceTarget> target =
        point.filter(CessnaControl::leads).flatMap(navigation -> target(navigation, now));
    lookAtSurfaces();
    boolean mayMove = mayMove(now, target.isPresent());
    if (!mayMove && (loggedPhase == FlightPhase.CRUISE || loggedPhase == FlightPhase.HOLD)) {
      autopilot = new Autopilot(tuning.get()); // on a launcher its integrals would wind up
    }
    autopilot.armed(isArmed);
    Surfaces surfaces = mixing.of(autopilot.step(now, target));
    boolean elevons = outputs.get().elevons();
    if (elevons) {
      commandShare(Surfaces.LEFT_ELEVON, surfaces.leftElevon());
      commandShare(Surfaces.RIGHT_ELEVON, surfaces.rightElevon());
    }
    for (AircraftActuator actuator : AircraftActuator.values()) {
      if (elevons && actuator.isElevons()) {
        continue;
      }
      boolean idles = actuator == AircraftActuator.THROTTLE && !mayMove;
      double percentage = idles ? 0.0 : FULL_PERCENT * actuator.of(surfaces);
      if (actuator.holdsThroughSilence()) {
        command(actuator.actuatorName(), percentage, outputs.get().powerExpiry());
      } else {
        command(actuator.actuatorName(), percentage);
      }
    }
    report(now, target.isPresent());
    tellWind(now);
    if (reader.hasFlown() && !isGroundSaved) {
      isGroundSaved = true;
      remember();
      if (reader.lacksGround()) {
        trouble("the altitude of the ground is unknown: started in flight, it cannot land");
      }
    }
  }

  /** Whether it leads anywhere: a speed of 0 tells an aeroplane on the ground to stay there. */
  private static boolean leads(NavigationPoint point) {
    return point.speed().orElse(1.0) > 0.0;
  }

  /**
   * Whether it moves or may begin to: armed, with navigation, READY TIME after its first state,
   * within which a Safety Manager tells that it is not armed. Without navigation, one that is armed
   * and as fast as it must be to fly may be in flight against the wind.
   */
  private boolean mayMove(FlightState now, boolean navigates) {
    if (Double.isNaN(firstS)) {
      firstS = now.timeS();
    }
    boolean isReady = now.timeS() - firstS >= tuning.get().takeOff().readyTime();
    double flyingMps = tuning.get().guidance().leastSpeedMps(0.0);
    boolean isLed = navigates || now.calibratedAirspeedMps() >= flyingMps;
    return now.groundSpeedMps() > AT_REST_MPS || (isArmed && isReady && isLed);
  }

  private void lookAtSurfaces() {
    long now = clock().micros();
    SurfaceMixing newest =
        new SurfaceMixing(
            roster.left(AircraftActuator.AILERON.actuatorName(), now),
            roster.left(AircraftActuator.ELEVATOR.actuatorName(), now),
            roster.left(AircraftActuator.RUDDER.actuatorName(), now));
    if (!newest.equals(mixing)) {
      mixing = newest;
      remark("authority", newest.equals(SurfaceMixing.SOUND) ? "" : newest.words());
      if (newest.equals(SurfaceMixing.SOUND)) {
        log("all surfaces are available");
      } else {
        trouble(newest.words());
      }
    }
  }

  /**
   * Navigation point relative to the aircraft now, rotated by the attitude from which it was
   * computed.
   */
  private Optional<GuidanceTarget> target(NavigationPoint point, FlightState now) {
    Optional<FlightState> then = stateOf(point).flatMap(reader::read);
    Optional<Point> ned = nedOf(point);
    if (then.isEmpty() || ned.isEmpty()) {
      return Optional.empty();
    }
    FlightState from = then.get();
    return Optional.of(
        new GuidanceTarget(
            ned.get().x() + from.northM() - now.northM(),
            ned.get().y() + from.eastM() - now.eastM(),
            from.altitudeM() - ned.get().z(),
            point.speed()));
  }

  private void report(FlightState state, boolean navigating) {
    FlightPhase phase = autopilot.phase();
    boolean news = phase != loggedPhase || navigating != loggedNavigating;
    if (news) {
      log(
          LogLevelEnum.INFO,
          "phase " + phase + (navigating ? "" : ", no navigation: " + without(phase)));
      if (phase == FlightPhase.GO_AROUND && phase != loggedPhase) {
        log(LogLevelEnum.ERROR, autopilot.refusalWords());
      }
      if (phase == FlightPhase.STOPPED && loggedPhase == FlightPhase.ROLL) {
        trouble(
            String.format(
                Locale.ROOT,
                "take-off rejected at %.0f m/s over ground, calibrated airspeed %.0f m/s",
                state.groundSpeedMps(),
                state.calibratedAirspeedMps()));
      }
      loggedPhase = phase;
      loggedNavigating = navigating;
    }
    if (news || state.timeS() >= statusDueS) {
      publish(ControlStatus.CHANNEL, status(navigating));
      statusDueS = state.timeS() + STATUS_INTERVAL_S;
    }
  }

  /** Says that it flies faster than ordered, until it has not for a while. */
  private void tellWind(FlightState state) {
    OptionalDouble raised = autopilot.raisedToMps();
    if (raised.isPresent()) {
      String what =
          String.format(
              Locale.ROOT,
              "wind of %.0f m/s: airspeed raised to %.0f m/s for MIN GROUND SPEED; MAX SPEED is %.0f m/s",
              autopilot.windMps(),
              raised.getAsDouble(),
              tuning.get().guidance().maxSpeed());
      if (Double.isNaN(raisedS)) {
        trouble(what);
      }
      remark("wind", what);
      raisedS = state.timeS();
    } else if (state.timeS() - raisedS > RAISED_FOR_S) {
      remark("wind", "");
      raisedS = Double.NaN;
    }
  }

  private static String without(FlightPhase phase) {
    return switch (phase) {
      case RUN_UP -> "waiting on the brakes";
      case STOPPED -> "stopped on the brakes";
      case HOLD -> "wings level, later circling, altitude held";
      case FLARE -> "touching down";
      case ROLL, ROTATE, CLIMB_OUT, CRUISE, GO_AROUND -> "climbing to the safe height";
    };
  }

  private ControlStatus status(boolean navigating) {
    ControlStatus status = new ControlStatus().phase(autopilot.phase()).navigating(navigating);
    boolean flying =
        switch (autopilot.phase()) {
          case CLIMB_OUT, CRUISE, HOLD, GO_AROUND -> true;
          case RUN_UP, ROLL, ROTATE, STOPPED, FLARE -> false;
        };
    return flying
        ? status
            .bank(autopilot.bankDemandRad())
            .pitch(autopilot.pitchDemandRad())
            .altitude(autopilot.altitudeDemandM())
            .airspeed(autopilot.speedDemandMps())
        : status;
  }

  @Override
  protected void handOver(HandOver state) {
    super.handOver(state);
    reader.handOver(state);
    autopilot.transfer(Transfer.saving(state));
    state.number(FIRST_STATE, firstS);
  }

  @Override
  protected void takeOver(HandOver state) {
    reader.takeOver(state);
    firstS = state.number(FIRST_STATE).orElse(firstS);
    if (!state.isFresh(nowS())) {
      return; // the aircraft is elsewhere, in another phase
    }
    super.takeOver(state);
    if (isOfMyClass(state)) {
      autopilot.transfer(Transfer.restoring(state));
    } else {
      takeOverCommands();
    }
  }

  /** Starts from the last commands (bumpless transfer). */
  private void takeOverCommands() {
    if (lastCommand(AircraftActuator.THROTTLE.actuatorName()).isEmpty()) {
      return;
    }
    boolean elevons = outputs.get().elevons();
    double left = lastShare(Surfaces.LEFT_ELEVON);
    double right = lastShare(Surfaces.RIGHT_ELEVON);
    autopilot.takeOver(
        elevons ? (left - right) / 2.0 : lastShare(AircraftActuator.AILERON.actuatorName()),
        elevons ? (left + right) / 2.0 : lastShare(AircraftActuator.ELEVATOR.actuatorName()),
        lastShare(AircraftActuator.RUDDER.actuatorName()),
        lastShare(AircraftActuator.THROTTLE.actuatorName()));
  }

  private void lacking(List<String> missing) {
    if (!missing.equals(loggedMissing)) {
      loggedMissing = missing;
      log(LogLevelEnum.WARN, "state lacks " + missing + ": no commands until they are available");
    }
  }

  @Override
  protected Map<String, Double> neutral() {
    Map<String, Double> neutral = AircraftActuator.neutral();
    if (outputs.get().elevons()) {
      double elevator = neutral.remove(AircraftActuator.ELEVATOR.actuatorName());
      neutral.remove(AircraftActuator.AILERON.actuatorName());
      neutral.put(Surfaces.LEFT_ELEVON, elevator);
      neutral.put(Surfaces.RIGHT_ELEVON, elevator);
    }
    return neutral;
  }
}
