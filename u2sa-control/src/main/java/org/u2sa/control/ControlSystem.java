package org.u2sa.control;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.handover.HandOver;

/**
 * Turns navigation points into actuator commands (thesis 3.2.3.5). In: navigation, state,
 * manual-orders. Out: actuation, manual-state.
 *
 * <p>{@link #control} is called once per new state, on the service's thread. A navigation point
 * older than STALE AFTER counts as absent. When states stop, no commands are sent, and the last
 * ones expire after COMMAND EXPIRY; when the service ends, actuators are left {@linkplain
 * #neutral() neutral}.
 *
 * <p>A control system that {@linkplain #obeysWithoutState() needs no state} obeys each navigation
 * point on arrival if no state has arrived for STALE AFTER (thesis 4.3.2).
 */
public abstract class ControlSystem extends EventDrivenService {
  /** The subsystem of navigation points for the vehicle as a whole. */
  protected static final String VEHICLE = "VEHICLE";

  private static final double FULL_PERCENT = 100.0;
  private static final int MAX_SUBSYSTEMS = 500; // beyond this number, silent ones are dropped

  private record Limits(
      @Variable(unit = "s", min = 0.02, max = 60, ifAbsent = 0.5)
          @Description("Lifetime of a command that is not renewed.")
          double commandExpiry,
      @Variable(unit = "s", min = 0, max = 10, ifAbsent = 0.5)
          @Description(
              "Time over which commands blend from those of the control system that this one replaces (bumpless transfer).")
          double blendTime,
      @Variable(unit = "s", min = 0.02, max = 60, ifAbsent = 1)
          @Description("Age at which a navigation point counts as absent.")
          double staleAfter) {}

  private final Settings<Limits> limits = settings(Limits.class);
  private final CommandBlend blend = new CommandBlend();
  private final boolean isSwap;
  private StateHistory states = new StateHistory();
  private final Map<String, NavigationPoint> points = new HashMap<>(); // newest, by subsystem
  private final Map<String, NavigationPoint> placed =
      new HashMap<>(); // newest point whose state is stored
  private double stepS;
  private long heardStateMicros = Long.MIN_VALUE; // by the run's clock
  private long controlledMicros = Long.MIN_VALUE; // by the run's clock
  private double neutralS;
  private boolean isExpiryReported;
  private boolean isStateless; // states are origins, one per navigation point

  /**
   * @param serviceName default name, overridden by the variable SERVICE NAME
   */
  protected ControlSystem(ServiceContext context, String serviceName) {
    super(context, ServiceRole.CONTROL_SYSTEM, serviceName);
    isSwap = context.isSwap();
    states.span(Clock.micros(limits.get().staleAfter()));
    subscribe(Channels.NAVIGATION, this::onNavigation);
    subscribe(Channels.STATE, this::onState);
    subscribe(Channels.MANUAL_ORDERS, this::onManualOrder);
    registerPublisher(Channels.ACTUATION);
    registerPublisher(Channels.MANUAL_STATE);
  }

  /**
   * Commands the actuators, by {@link #command}. Called for each state newer than the previous one.
   *
   * @param state the newest estimate, in GLOBAL or LOCAL_NED, depending on the frame it came in
   * @param point target, in the vehicle's own frame (BODY) at the point's timestamp; empty if
   *     absent or stale
   */
  protected abstract void control(StateInformation state, Optional<NavigationPoint> point);

  /** Safe commands of this control system's actuators, by actuator name [%, −100…100]. */
  protected abstract Map<String, Double> neutral();

  /**
   * Whether a navigation point alone suffices. Without states, such a control system is called with
   * the origin of LOCAL_NED, heading north, without speed or attitude.
   */
  protected boolean obeysWithoutState() {
    return false;
  }

  /**
   * Whether {@link #control} is currently called for navigation points because no states arrive.
   */
  public final boolean isStateless() {
    return isStateless;
  }

  /** The subsystem that this service moves; the vehicle, unless overridden. Constant. */
  protected String subsystem() {
    return VEHICLE;
  }

  /**
   * Executes an order to drive by hand and returns the answer; refuses unless overridden.
   *
   * @param late reason for refusing an order to begin; empty if it arrived in time
   */
  protected ManualState byHand(ManualOrder order, Optional<String> late) {
    ManualState state = new ManualState();
    return order.active()
        ? state.reason(late.orElse("this vehicle cannot be driven by hand"))
        : state;
  }

  private void onManualOrder(ManualOrder order) {
    if (subsystem().equals(VEHICLE)) {
      publish(
          Channels.MANUAL_STATE,
          byHand(order, order.active() ? lateness(order) : Optional.empty())
              .requestId(order.requestId()));
    }
  }

  private void onNavigation(NavigationPoint point) {
    if (points.size() >= MAX_SUBSYSTEMS && !points.containsKey(point.subsystem())) {
      points.values().removeIf(each -> !states.isFresh(each)); // unknown names
      placed.keySet().retainAll(points.keySet());
    }
    points.put(point.subsystem(), point);
    if (obeysWithoutState() && point.subsystem().equals(subsystem()) && isAllThereIs(point)) {
      begin(true);
      points.put(subsystem(), point);
      StateInformation origin =
          new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).psi(0.0);
      origin.timestamp(point.timestamp().getAsLong());
      take(origin);
    }
  }

  /** Whether the navigation point is fresh but no state is. */
  private boolean isAllThereIs(NavigationPoint point) {
    long now = clock().micros();
    long span = Clock.micros(limits.get().staleAfter());
    boolean hasState = heardStateMicros != Long.MIN_VALUE && now - heardStateMicros <= span;
    return !hasState
        && point.timestamp().isPresent()
        && Math.abs(now - point.timestamp().getAsLong()) <= span;
  }

  /** Discards results computed from states of the other kind, which have a different origin. */
  private void begin(boolean stateless) {
    if (stateless != isStateless) {
      isStateless = stateless;
      log(stateless ? "no state: obeying navigation points alone" : "a state again");
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
    take(fromNorth(state));
  }

  /**
   * The state in GLOBAL or LOCAL_NED, where psi is clockwise from north. A point on a grid whose
   * position is unknown is left unconverted.
   */
  private static StateInformation fromNorth(StateInformation state) {
    if (state.referenceFrame().equals(ReferenceFrame.LOCAL_ENU)) {
      return state.in(ReferenceFrame.LOCAL_NED);
    }
    boolean isPlaced = state.x().isPresent() && state.y().isPresent();
    return state.referenceFrame().isUtm() && isPlaced ? state.in(ReferenceFrame.GLOBAL) : state;
  }

  private void take(StateInformation state) {
    states.span(Clock.micros(limits.get().staleAfter()));
    if (!states.add(state)) {
      log(LogLevelEnum.DEBUG, "ignored a state that is not newer than the last: " + state);
      return;
    }
    stepS = Clock.seconds(states.lastStepMicros());
    warnOfExpiry();
    long now = clock().micros();
    double pauseS =
        controlledMicros == Long.MIN_VALUE ? 0.0 : Clock.seconds(now - controlledMicros);
    neutralS = Math.max(0.0, pauseS - limits.get().commandExpiry());
    controlledMicros = now;
    points.values().stream()
        .filter(point -> stateOf(point).isPresent())
        .forEach(point -> placed.put(point.subsystem(), point));
    control(state, navigationPoint(subsystem()));
  }

  /** Says once that commands expire before the next state renews them: the vehicle jerks. */
  private void warnOfExpiry() {
    double expiryS = limits.get().commandExpiry();
    if (!isExpiryReported && stepS > expiryS) {
      isExpiryReported = true;
      log(
          LogLevelEnum.WARN,
          String.format(
              Locale.ROOT,
              "commands expire %.2f s after a state, but the next one came after %.2f s: expected a COMMAND EXPIRY longer than the period of states",
              expiryS,
              stepS));
    }
  }

  /**
   * Time between the previous and the current state [s], by timestamps; 0 for the first state and
   * after a gap longer than STALE AFTER, so that integrators neither start nor resume with a jump.
   */
  protected final double stepS() {
    return stepS;
  }

  /**
   * How long the actuators had been neutral at the current state because the previous commands had
   * expired [s]; 0 if they had not. The vehicle has not moved as commanded since.
   */
  protected final double neutralS() {
    return neutralS;
  }

  /**
   * The newest navigation point of a subsystem, unless it is stale by the newest state's time. If
   * the state it was computed from has not been received, because it is late or was superseded in
   * the inbox, uses the last point with a received state.
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
   * State from which a navigation point was computed, with the same timestamp; empty if no longer
   * stored.
   */
  protected final Optional<StateInformation> stateOf(NavigationPoint point) {
    return point.timestamp().isEmpty()
        ? Optional.empty()
        : states.at(point.timestamp().getAsLong());
  }

  /**
   * Rotates a navigation point from BODY to north, east, down relative to the vehicle [m], by the
   * attitude from which it was computed; empty if that state is no longer stored.
   */
  protected final Optional<Point> nedOf(NavigationPoint point) {
    return stateOf(point).map(state -> ned(point.point(), state));
  }

  private static Point ned(Point body, StateInformation state) {
    return new Attitude(state.phi().orElse(0.0), state.theta().orElse(0.0), state.psi().orElse(0.0))
        .nedOf(body);
  }

  /**
   * Commands an actuator until the next command or until COMMAND EXPIRY.
   *
   * @param percentage bounded to −100…100 [%]
   * @throws IllegalArgumentException if the percentage is not a number
   */
  protected final void command(String actuator, double percentage) {
    command(actuator, percentage, limits.get().commandExpiry());
  }

  /**
   * Commands an actuator until the next command or the given expiry.
   *
   * @param percentage bounded to −100…100 [%]
   * @param expiryS how long the command stays valid [s]
   * @throws IllegalArgumentException if a value is not a number
   */
  protected final void command(String actuator, double percentage, double expiryS) {
    double wanted = Math.max(-100.0, Math.min(100.0, percentage));
    double bounded = blend.command(actuator, wanted, clock().micros(), limits.get().blendTime());
    publish(Channels.ACTUATION, PercentageCommand.of(actuator, bounded).expiry(expiryS));
  }

  /**
   * Commands an actuator by angle, speed or force, if it announced support for it; by a percentage
   * while blending from another control system's commands.
   *
   * @param typed command addressed to the actuator
   * @param percentage equivalent percentage [%]
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

  /** Commands an actuator by a fraction of full command, −1…1. */
  protected final void commandShare(String actuator, double share) {
    command(actuator, FULL_PERCENT * share);
  }

  /** Last command of an actuator, by this or the previous control system [−1…1]; 0 if none. */
  protected final double lastShare(String actuator) {
    return lastCommand(actuator).orElse(0.0) / FULL_PERCENT;
  }

  /** Last command of an actuator, by this or the previous control system [%]. */
  protected final OptionalDouble lastCommand(String actuator) {
    return blend.last(actuator);
  }

  /** Whether the predecessor has the same class, so that its state is complete. */
  protected final boolean isOfMyClass(HandOver state) {
    return state.className().equals(getClass().getName());
  }

  /**
   * Whether this control system replaces one that moved the vehicle until now. Otherwise it was
   * started or restarted: its actuators have been neutral, and commands, speeds and integrals that
   * it saved no longer describe the vehicle's motion.
   */
  protected final boolean isSwap() {
    return isSwap;
  }

  /** {@inheritDoc} Overrides must call super. */
  @Override
  protected void handOver(HandOver state) {
    if (!isStateless) {
      state.messages("STATES", states.all());
      state.messages("POINTS", points.values());
      state.messages("PLACED", placed.values());
    }
    blend.handOver(state);
  }

  /** {@inheritDoc} Overrides must call super first. */
  @Override
  protected void takeOver(HandOver state) {
    if (!isSwap) {
      return; // where the vehicle was, and how it was moved, is out of date
    }
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

  /** Sets the actuators to neutral immediately; overrides must call super. */
  @Override
  protected void release() {
    blend.end();
    neutral().forEach(this::command);
  }
}
