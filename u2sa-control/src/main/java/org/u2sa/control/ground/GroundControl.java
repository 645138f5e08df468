package org.u2sa.control.ground;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.u2sa.control.ControlSystem;
import org.u2sa.control.allocation.ActuatorRoster;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * Controls a ground vehicle from the navigation point and its measured motion, or from an
 * operator's manual commands; stops if a motor is lost. In: navigation, state, arming-state,
 * actuators, failsafe, manual-orders, manual-drive. Out: manual-state.
 */
abstract class GroundControl extends ControlSystem {
  private final ActuatorRoster roster = new ActuatorRoster();
  private final Settings<HandDriving.Limits> handLimits = settings(HandDriving.Limits.class);
  private final HandDriving hand = new HandDriving();
  private long saidMicros; // when the state of driving by hand was last published
  private boolean navigating;
  private boolean powerless;
  private boolean armed = true; // without an arming service, motors obey immediately
  private OptionalDouble headingRad = OptionalDouble.empty(); // of the previous state

  GroundControl(ServiceContext context) {
    super(context, "Control");
    subscribe(Channels.ARMING_STATE, this::onArming);
    subscribe(Channels.FAILSAFE, failsafe -> hand.see(failsafe.action()).ifPresent(this::ended));
    subscribe(Channels.MANUAL_DRIVE, drive -> hand.see(drive, clock().micros(), orderExpiryS()));
    subscribe(Channels.GOALS, goals -> hand.see(goals, clock().micros()));
    subscribe(Channels.ACTUATORS, announced -> roster.see(announced, clock().micros()));
  }

  /** Names of the actuators that are all required to drive. */
  abstract List<String> motors();

  /**
   * Commands the motors.
   *
   * @param target target; empty to stop
   * @param measured measured motion, as far as feedback may learn from it
   */
  abstract void drive(StateInformation state, Optional<GroundTarget> target, Measured measured);

  @Override
  protected final void control(StateInformation state, Optional<NavigationPoint> point) {
    long now = clock().micros();
    if (hand.isActive() && now - saidMicros >= Clock.MICROS_PER_SECOND) {
      publishHand(hand.state()); // for a Mission Manager that starts during the drive
    }
    if (neutralS() > 0.0) {
      coasted(neutralS());
    }
    drive(state, hand.isActive() ? wanted() : target(state, point), measured(state));
  }

  /** Sees that the motors have been neutral for a time [s]: the vehicle slows down. */
  void coasted(double seconds) {}

  @Override
  protected final Map<String, Double> neutral() {
    Map<String, Double> all = new LinkedHashMap<>(); // Map.of's order differs between processes
    motors().forEach(motor -> all.put(motor, 0.0));
    return all;
  }

  /**
   * Measured motion of the vehicle.
   *
   * @param forwardMps forward speed [m/s]; empty if unknown
   * @param yawRateRadPerS yaw rate [rad/s], left positive; empty if unknown
   */
  record Measured(OptionalDouble forwardMps, OptionalDouble yawRateRadPerS) {
    /** Nothing measured: feedback must not learn without a state, or while motors do not obey. */
    static final Measured NOTHING = new Measured(OptionalDouble.empty(), OptionalDouble.empty());
  }

  /**
   * Target; empty to stop. A motor announced as lost, or disarming, also stops the vehicle, which
   * would otherwise lurch when the motor obeys again, or rest as if stalled.
   */
  private Optional<GroundTarget> target(StateInformation now, Optional<NavigationPoint> point) {
    Optional<StateInformation> then = point.flatMap(this::stateOf);
    Optional<Point> ned = point.flatMap(this::nedOf);
    boolean stands = !armed || isPowerless() || hand.isHeld(clock().micros());
    Optional<GroundTarget> target =
        then.isEmpty() || ned.isEmpty() || stands
            ? Optional.empty()
            : GroundTarget.seenFrom(then.get(), ned.get(), now, point.orElseThrow());
    if (target.isPresent() != navigating) {
      navigating = target.isPresent();
      String why = armed ? "no navigation" : "disarmed";
      log(navigating ? "driving" : why + ": stopped");
    }
    return target;
  }

  private Optional<GroundTarget> wanted() {
    return isPowerless()
        ? Optional.empty()
        : hand.wanted(handLimits.get(), clock().micros()).map(GroundTarget::byHand);
  }

  /** Whether an operator may drive by hand. */
  boolean isDrivenByHand() {
    return true;
  }

  @Override
  protected ManualState byHand(ManualOrder order, Optional<String> late) {
    if (!isDrivenByHand()) {
      return super.byHand(order, late);
    }
    ManualState state = hand.obey(order, late);
    remember();
    log(
        LogLevelEnum.WARN,
        "driving by hand, "
            + (order.active() ? "begun" : "ended")
            + " by \""
            + order.operator()
            + "\": "
            + state.reason().orElse("takeovers: " + state.takeovers()));
    return state;
  }

  private void onArming(ArmingState state) {
    armed = state.armed();
    hand.see(armed).ifPresent(this::ended);
  }

  private void ended(ManualState state) {
    log(LogLevelEnum.WARN, "driving by hand ended: " + state.reason().orElse(""));
    publishHand(state);
    remember();
  }

  private void publishHand(ManualState state) {
    saidMicros = clock().micros();
    publish(Channels.MANUAL_STATE, state);
  }

  /** Publishes the current state, which may differ from a predecessor's last message. */
  @Override
  protected void begin() {
    super.begin();
    publishHand(hand.state());
  }

  @Override
  protected void handOver(HandOver state) {
    super.handOver(state);
    hand.handOver(state);
  }

  @Override
  protected void takeOver(HandOver state) {
    super.takeOver(state);
    if (isDrivenByHand()) {
      hand.takeOver(state, isSwap(), clock().micros());
    }
  }

  /** Reports that the vehicle does not move; motors that nobody announced explain it. */
  void unmoved(String warning) {
    List<String> unknown =
        motors().stream().filter(motor -> !roster.knows(motor)).collect(Collectors.toList());
    trouble(
        unknown.isEmpty()
            ? warning
            : "the vehicle does not move, and no service has announced "
                + String.join(", ", unknown));
  }

  private boolean isPowerless() {
    long now = clock().micros();
    List<String> lost =
        motors().stream()
            .filter(motor -> roster.left(motor, now) == 0.0)
            .collect(Collectors.toList());
    boolean isWithheld = motors().stream().anyMatch(roster::isWithheld);
    boolean isNow = isWithheld || !lost.isEmpty();
    if (isNow != powerless) {
      powerless = isNow;
      String why =
          lost.isEmpty() ? "a radio or stop has precedence" : "lost " + String.join(", ", lost);
      log(powerless ? why : "all motors are available");
    }
    return powerless;
  }

  private Measured measured(StateInformation state) {
    Measured measured = new Measured(forwardMps(state), yawRateRadPerS(state, stepS()));
    headingRad = state.psi();
    boolean obey = armed && neutralS() == 0.0;
    return obey && !isStateless() ? measured : Measured.NOTHING;
  }

  private static OptionalDouble forwardMps(StateInformation state) {
    if (state.xDot().isEmpty() || state.yDot().isEmpty() || state.psi().isEmpty()) {
      return OptionalDouble.empty();
    }
    boolean northFirst = state.referenceFrame().isLocal();
    double x = state.xDot().getAsDouble();
    double y = state.yDot().getAsDouble();
    double heading = state.psi().getAsDouble();
    double north = northFirst ? x : y;
    double east = northFirst ? y : x;
    return OptionalDouble.of(north * Math.cos(heading) + east * Math.sin(heading));
  }

  /** Measured yaw rate, or the heading difference to the previous state divided by the step. */
  private OptionalDouble yawRateRadPerS(StateInformation state, double stepS) {
    if (state.psiDot().isPresent()) {
      return OptionalDouble.of(-state.psiDot().getAsDouble());
    }
    if (state.psi().isEmpty() || headingRad.isEmpty() || stepS == 0.0) {
      return OptionalDouble.empty();
    }
    double turned =
        Math.IEEEremainder(state.psi().getAsDouble() - headingRad.getAsDouble(), 2.0 * Math.PI);
    return OptionalDouble.of(-turned / stepS);
  }
}
