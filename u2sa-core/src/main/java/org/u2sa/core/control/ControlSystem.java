package org.u2sa.core.control;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ActuatorCommand;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.PercentageCommand;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.HandOver;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Turns navigation points into actuator commands (thesis 3.2.3.5). In: navigation, state. Out:
 * actuation.
 *
 * <p>{@link #control} is called once for each new state, on the service's thread. A navigation
 * point that is older than STALE AFTER counts as absent. When states stop coming nothing is
 * commanded, and what was commanded last expires after COMMAND EXPIRY; when the service ends,
 * actuators are left {@linkplain #neutral() neutral}.
 *
 * <p>A control system that {@linkplain #obeysWithoutState() needs no state} obeys each navigation
 * point when it comes, while no state has come for STALE AFTER (thesis 4.3.2).
 */
public abstract class ControlSystem extends EventDrivenService {
  /** The subsystem of navigation points for the vehicle as a whole. */
  protected static final String VEHICLE = "VEHICLE";

  private static final double FULL_PERCENT = 100.0;

  private record Limits(
      @Variable(
              unit = "s",
              min = 0.02,
              max = 60,
              ifAbsent = 0.5,
              text = "How long an actuator obeys a command that is not renewed.")
          double commandExpiry,
      @Variable(
              unit = "s",
              min = 0,
              max = 10,
              ifAbsent = 0.5,
              text =
                  "Time over which commands blend from those of a control system that this one replaces.")
          double blendTime,
      @Variable(
              unit = "s",
              min = 0.02,
              max = 60,
              ifAbsent = 1,
              text = "Age at which a navigation point counts as absent.")
          double staleAfter) {}

  private final Settings<Limits> limits = settings(Limits.class);
  private final CommandBlend blend = new CommandBlend();
  private StateHistory states = new StateHistory();
  private final Map<String, NavigationPoint> points = new HashMap<>(); // newest, by subsystem
  private final Map<String, NavigationPoint> placed =
      new HashMap<>(); // newest whose state is remembered
  private double stepS;
  private long heardStateMicros = Long.MIN_VALUE; // of the run's clock
  private boolean isStateless; // then the states are origins, one for each navigation point

  /**
   * @param serviceName the name, unless the variable SERVICE NAME says another
   */
  protected ControlSystem(ServiceContext context, String serviceName) {
    super(context, ServiceRole.CONTROL_SYSTEM, serviceName);
    states.span(Clock.micros(limits.get().staleAfter()));
    subscribe(Channels.NAVIGATION, this::onNavigation);
    subscribe(Channels.STATE, this::onState);
    registerPublisher(Channels.ACTUATION);
  }

  /**
   * Commands the actuators, by {@link #command}. Called for each state that is newer than the one
   * before.
   *
   * @param state the newest estimate
   * @param point where the vehicle is to go, in its own frame (BODY) at its timestamp; empty if
   *     there is none or it is stale
   */
  protected abstract void control(StateInformation state, Optional<NavigationPoint> point);

  /**
   * The percentages at which the actuators of this control system do no harm, by actuator name [%,
   * −100…100].
   */
  protected abstract Map<String, Double> neutral();

  /**
   * Whether a navigation point alone tells where to go. Such a control system is called with the
   * origin of LOCAL_NED, heading north, in place of a state: it says nothing of speed or attitude.
   */
  protected boolean obeysWithoutState() {
    return false;
  }

  /** Whether {@link #control} is called for navigation points, as no state comes. */
  public final boolean isStateless() {
    return isStateless;
  }

  private void onNavigation(NavigationPoint point) {
    points.put(point.subsystem(), point);
    if (obeysWithoutState() && point.subsystem().equals(VEHICLE) && isAllThereIs(point)) {
      begin(true);
      points.put(VEHICLE, point);
      StateInformation origin =
          new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).psi(0.0);
      origin.timestamp(point.timestamp().getAsLong());
      take(origin);
    }
  }

  /** Whether a navigation point is fresh, and no state is. */
  private boolean isAllThereIs(NavigationPoint point) {
    long now = clock().micros();
    long span = Clock.micros(limits.get().staleAfter());
    boolean hasState = heardStateMicros != Long.MIN_VALUE && now - heardStateMicros <= span;
    return !hasState
        && point.timestamp().isPresent()
        && Math.abs(now - point.timestamp().getAsLong()) <= span;
  }

  /** Forgets what was computed from states of the other kind: they have another origin. */
  private void begin(boolean stateless) {
    if (stateless != isStateless) {
      isStateless = stateless;
      log(stateless ? "no state: obeys navigation points alone" : "a state again");
      states = new StateHistory();
      points.clear();
      placed.clear();
    }
  }

  private void onState(StateInformation state) {
    if (state.timestamp().isEmpty()) {
      log(LogLevelEnum.WARN, "ignored a state without a timestamp: " + state);
      return;
    }
    heardStateMicros = clock().micros();
    begin(false);
    take(state);
  }

  private void take(StateInformation state) {
    states.span(Clock.micros(limits.get().staleAfter()));
    if (!states.add(state)) {
      log(LogLevelEnum.DEBUG, "ignored a state that is not newer than the last: " + state);
      return;
    }
    stepS = Clock.seconds(states.lastStepMicros());
    points.values().stream()
        .filter(point -> stateOf(point).isPresent())
        .forEach(point -> placed.put(point.subsystem(), point));
    control(state, navigationPoint(VEHICLE));
  }

  /**
   * Time from the state before to the present one [s], by their timestamps; 0 for the first one,
   * and for one after a gap longer than STALE AFTER, so that integrators neither start nor resume
   * with a jump.
   */
  protected final double stepS() {
    return stepS;
  }

  /**
   * The newest navigation point of a subsystem, unless it is stale by the newest state's time. One
   * whose state was not seen, because it is still on its way or a newer one took its place in the
   * inbox, gives way to the last one whose state was.
   */
  protected final Optional<NavigationPoint> navigationPoint(String subsystem) {
    Optional<NavigationPoint> newest =
        Optional.ofNullable(points.get(subsystem)).filter(states::isFresh);
    if (newest.flatMap(this::stateOf).isPresent()) {
      return newest;
    }
    Optional<NavigationPoint> before =
        Optional.ofNullable(placed.get(subsystem)).filter(states::isFresh);
    return newest.isPresent() && before.isPresent() ? before : newest;
  }

  /**
   * The state from which a navigation point was computed: the one with the same timestamp, if it is
   * remembered.
   */
  protected final Optional<StateInformation> stateOf(NavigationPoint point) {
    return point.timestamp().isEmpty()
        ? Optional.empty()
        : states.at(point.timestamp().getAsLong());
  }

  /**
   * Where a navigation point of BODY lies from the vehicle: north, east, down [m], turned by the
   * attitude from which it was computed; empty if that state is no longer remembered.
   */
  protected final Optional<Point> nedOf(NavigationPoint point) {
    return stateOf(point).map(state -> ned(point.point(), state));
  }

  private static Point ned(Point body, StateInformation state) {
    boolean local = state.referenceFrame().isLocal();
    StateInformation ned = state.in(local ? ReferenceFrame.LOCAL_NED : ReferenceFrame.GLOBAL);
    return new Attitude(ned.phi().orElse(0.0), ned.theta().orElse(0.0), ned.psi().orElse(0.0))
        .nedOf(body);
  }

  /**
   * Commands an actuator until the next command, or until COMMAND EXPIRY has passed.
   *
   * @param percentage bounded to −100…100 [%]
   * @throws IllegalArgumentException if the percentage is not a number
   */
  protected final void command(String actuator, double percentage) {
    command(actuator, percentage, limits.get().commandExpiry());
  }

  /**
   * Commands an actuator until the next command, or until the given time has passed.
   *
   * @param percentage bounded to −100…100 [%]
   * @param expiryS how long it holds without another command [s]
   * @throws IllegalArgumentException if a value is not a number
   */
  protected final void command(String actuator, double percentage, double expiryS) {
    double wanted = Math.max(-100.0, Math.min(100.0, percentage));
    double bounded = blend.command(actuator, wanted, clock().micros(), limits.get().blendTime());
    publish(Channels.ACTUATION, PercentageCommand.of(actuator, bounded).expiry(expiryS));
  }

  /**
   * Commands an actuator by an angle, speed or force, for one that announced to take such; while
   * commands blend from those of another control system, by a percentage.
   *
   * @param typed addressed to the actuator
   * @param percentage that it stands for [%]
   */
  protected final void command(ActuatorCommand typed, double percentage) {
    String actuator = typed.actuatorName();
    double blended =
        blend.command(actuator, percentage, clock().micros(), limits.get().blendTime());
    double expiryS = limits.get().commandExpiry();
    publish(
        Channels.ACTUATION,
        blended == percentage
            ? typed.expiry(expiryS)
            : PercentageCommand.of(actuator, blended).expiry(expiryS));
  }

  /** Commands an actuator a share of all that it can [−1…1]. */
  protected final void commandShare(String actuator, double share) {
    command(actuator, FULL_PERCENT * share);
  }

  /** What an actuator was commanded last, by this or the control before [−1…1]; 0 if nothing. */
  protected final double lastShare(String actuator) {
    return lastCommand(actuator).orElse(0.0) / FULL_PERCENT;
  }

  /** The percentage that was commanded last, by this control system or the one before [%]. */
  protected final OptionalDouble lastCommand(String actuator) {
    return blend.last(actuator);
  }

  /** Whether a control of the same class hands over: then its state says all. */
  protected final boolean isOfMyClass(HandOver state) {
    return state.className().equals(getClass().getName());
  }

  /** {@inheritDoc} Subclasses that override it call it too. */
  @Override
  protected void handOver(HandOver state) {
    if (!isStateless) {
      state.messages("STATES", states.all());
      state.messages("POINTS", points.values());
      state.messages("PLACED", placed.values());
    }
    blend.handOver(state);
  }

  /** {@inheritDoc} Subclasses that override it call it first. */
  @Override
  protected void takeOver(HandOver state) {
    state.messages("STATES", StateInformation.class).forEach(states::add);
    if (!states.all().isEmpty()) {
      heardStateMicros = clock().micros();
    }
    state
        .messages("POINTS", NavigationPoint.class)
        .forEach(point -> points.put(point.subsystem(), point));
    state
        .messages("PLACED", NavigationPoint.class)
        .forEach(point -> placed.put(point.subsystem(), point));
    blend.takeOver(state, isOfMyClass(state));
  }

  /** Leaves the actuators neutral; subclasses that override it call it too. */
  @Override
  protected void release() {
    neutral().forEach(this::command);
  }
}
