package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.FenceOrderResult;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.safety.OperatorHeartbeat;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.actuator.EmergencyLatch;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.StreamDelay;

/**
 * Decides how the vehicle reacts to faults, by the failsafe matrix, and whether it may move at all
 * (arming). In: state, conditions, health, operator, power, actuators, goals, arming, manual-state,
 * emergency-stop, fence-orders, and restarted also the retained fence and failsafe. Out: failsafe,
 * arming-state, emergency-stop, fence, fence-orders.
 *
 * <p>Failsafes act only while the vehicle is armed and no pilot flies it. The most severe cause
 * wins.
 */
public final class SafetyManager extends PeriodicService {
  private static final String LAST_CLEAR = "LAST CLEAR"; // in the hand-over
  private static final int MAX_OPERATORS = 16;
  private static final String REPEATED = "this order was answered before: give it under another ID";
  private static final double CHECKS_PER_S = 10.0;
  private static final double SLOWEST_HZ = 1.0; // otherwise failsafes would come too late

  /**
   * After three regular heartbeats, one a second, an operator's clock was set, or a second program
   * has another clock [s]: with the gap before them and one after, less than OPERATOR DEADLINE, 5
   * s.
   */
  private static final double STEADY_AFTER_S = 1.9;

  private static final double REPEAT_INTERVAL_S = 1.0; // interval for unchanged states

  private final Settings<SafetyVariables> settings = settings(SafetyVariables.class);
  private final EmergencyLatch emergency;
  private String lastClear = ""; // of an emergency stop
  private long lastClearMicros; // timestamp
  private FailsafeState failsafeBefore = new FailsafeState(); // retained, of a lost predecessor
  private String clearBefore = ""; // the last one that the predecessor heard
  private final Conditions conditions = new Conditions();
  private final NamedServices named = new NamedServices(settings);
  private final SafetyPilot pilot = new SafetyPilot(settings, conditions);
  private final FenceWatch fenceWatch;
  private final FenceOrders fenceOrders;
  private final List<Watch> watches;
  private final FailsafeDecision decision;
  private final Arming arming;
  private final Predecessor predecessor;
  private final boolean isRestart;
  private final boolean isSwap;
  private boolean begun;
  private String saved = ""; // last saved part of the state
  private FailsafeAction said = FailsafeAction.CONTINUE;
  private List<Hazard> saidHazards = List.of();
  private double repeatDueS;
  private final Map<String, StreamDelay> heartbeats = new HashMap<>(); // by operator
  private long lateHeartbeats;
  private long beganMicros; // after a predecessor
  private boolean knowsOrders; // those that the predecessor obeyed
  private int saidFence; // fence version last published

  /**
   * Launcher constructor.
   *
   * @throws org.u2sa.interfaces.BadInputException if the fence's file is invalid
   */
  public SafetyManager(ServiceContext context) {
    super(context, ServiceRole.SAFETY_MANAGER, "SafetyManager", CHECKS_PER_S, SLOWEST_HZ);
    emergency = new EmergencyLatch(clock(), context.systemId());
    PositionWatch position = new PositionWatch(settings);
    FenceFile fence = new FenceFile(context.configuration(), clock());
    fenceWatch = new FenceWatch(this, settings, fence, position);
    fenceOrders = new FenceOrders(fenceWatch, this::lateness);
    List<ExtensionWatch> extensions = ExtensionWatch.discovered(this);
    watches = new ArrayList<>(Watches.standard(settings, conditions, named, position));
    watches.add(new GuardedWatch(pilot));
    watches.add(new GuardedWatch(fenceWatch));
    extensions.forEach(watch -> watches.add(new GuardedWatch(watch)));
    List<Hazard> hazards = watches.stream().map(Watch::hazard).collect(Collectors.toList());
    decision = new FailsafeDecision(this, settings, hazards);
    ArmingChecks checks = new ArmingChecks(this, settings, watches, conditions, emergency);
    arming = new Arming(this, checks, settings.get().armAtStart());
    isRestart = context.isRestart();
    predecessor = new Predecessor(clock().micros(), isRestart);
    isSwap = context.isSwap();
    beganMicros = isRestart || isSwap ? clock().micros() : Long.MIN_VALUE;
    registerPublisher(Channels.FAILSAFE);
    registerPublisher(Channels.ARMING_STATE);
    registerPublisher(Channels.EMERGENCY_STOP);
    registerPublisher(Channels.FENCE);
    registerPublisher(Channels.FENCE_ORDERS);
    heedsEmergencyStops(emergency.identities());
    handleMessagesAtSteps();
    failAtFirstError();
    Set<Channel<?>> heard = new LinkedHashSet<>(Watch.STANDARD);
    extensions.forEach(watch -> heard.addAll(watch.channels()));
    for (Channel<?> channel : heard) {
      subscribe(channel, message -> see(channel, message));
    }
    subscribe(Channels.CONDITIONS, this::onCondition);
    subscribe(Channels.MANUAL_STATE, pilot::see);
    subscribe(Channels.ARMING, this::obey);
    subscribe(Channels.EMERGENCY_STOP, this::stopOrGo);
    subscribe(Channels.FENCE_ORDERS, this::onFenceOrder);
    if (isRestart) { // what a predecessor said last, in case its saved state is lost
      subscribe(Channels.FENCE, this::onFenceBefore);
      subscribe(Channels.FAILSAFE, this::onFailsafeBefore);
    }
  }

  /**
   * The fence in force, without FENCE MARGIN, another object after each change; empty if none.
   * Thread-safe.
   */
  public Optional<Fence> fence() {
    return fenceWatch.whole();
  }

  /** Rejects an unreadable fence and, while armed, names that have not reported. */
  @Override
  protected Optional<String> configurationRefusal(Map<String, Object> values) {
    Optional<String> refusal = arming.isArmed() ? named.refusal(values) : Optional.empty();
    return refusal.or(() -> fenceWatch.configurationRefusal(values));
  }

  @Override
  protected void configurationChanged(Set<String> variableNames) {
    boolean otherFile = variableNames.contains(SafetyVariables.FENCE);
    if (otherFile || variableNames.contains(SafetyVariables.FENCE_MARGIN)) {
      try {
        if (otherFile) {
          fenceWatch.load();
        } else {
          fenceWatch.drawIn();
        }
        String file = settings.get().fence();
        log(file.isEmpty() ? "without a fence" : "fence " + file + " loaded");
      } catch (BadInputException e) {
        log(LogLevelEnum.ERROR, e.getMessage() + ": fence unchanged");
      }
    }
  }

  @Override
  protected void handOver(HandOver state) {
    long now = clock().micros();
    if (begun) {
      Predecessor.handOver(state, arming.isArmed());
    } else {
      predecessor.handOver(state);
    }
    arming.handOver(state);
    fenceOrders.handOver(state);
    decision.handOver(state);
    conditions.handOver(state);
    state.text(LAST_CLEAR, lastClear);
    watches.forEach(watch -> watch.handOver(state, now));
  }

  @Override
  protected void takeOver(HandOver state) {
    long now = clock().micros();
    predecessor.takeOver(state);
    arming.takeOver(state, isSwap);
    fenceOrders.takeOver(state);
    knowsOrders = true;
    decision.takeOver(state, now);
    conditions.takeOver(state);
    clearBefore = state.text(LAST_CLEAR).orElse("");
    lastClear = clearBefore;
    watches.forEach(watch -> watch.takeOver(state, now, isSwap));
  }

  /** Saves the state for a successor, if it has changed. */
  private void save() {
    String state =
        watches.stream()
            .map(Watch::saved)
            .collect(
                Collectors.joining(
                    " ", arming.isArmed() + lastClear + decision.saved(), conditions.saved()));
    if (!state.equals(saved)) {
      saved = state;
      remember();
    }
  }

  private void beginAfterPredecessor() {
    begun = true;
    beganMicros = isRestart || isSwap ? clock().micros() : Long.MIN_VALUE;
    boolean isKnownClear =
        predecessor.isStateLost()
            ? predecessor.spokeAfter(lastClearMicros)
            : lastClear.equals(clearBefore);
    boolean wasStopped = isRestart && !lastClear.isEmpty() && !isKnownClear;
    if (predecessor.isStateLost()) {
      decision.resume(failsafeBefore, clock().micros());
      trouble("restarted without a saved state: continues by retained messages");
    }
    if (wasStopped) {
      log(LogLevelEnum.WARN, "disarmed: an emergency stop was cleared while no Safety Manager ran");
    }
    if (predecessor.wasArmed() && !emergency.isStopped() && !wasStopped) {
      arming.stayArmed();
    } else {
      decision.acknowledge(); // causes count while armed; an emergency stop persists by itself
    }
    if (!isSwap && (isRestart || predecessor.wasHeard())) {
      arming.startsLater(
          isRestart
              ? "it was restarted"
              : "another Safety Manager of this system was active shortly before");
    }
  }

  private void see(Channel<?> channel, U2SAData message) {
    long now = clock().micros();
    if (message instanceof OperatorHeartbeat heartbeat && isLate(heartbeat, now)) {
      return;
    }
    predecessor.see(message, now);
    arming.see(message, now);
    named.see(message);
    for (Watch watch : watches) {
      if (watch.hears(channel)) {
        watch.see(message, now);
      }
    }
  }

  /** A late heartbeat tells of an operator who may have gone; the clocks of both may differ. */
  private boolean isLate(OperatorHeartbeat heartbeat, long nowMicros) {
    if (heartbeats.size() >= MAX_OPERATORS && !heartbeats.containsKey(heartbeat.operator())) {
      heartbeats.clear(); // invented names
    }
    boolean isLate =
        heartbeats
            .computeIfAbsent(heartbeat.operator(), name -> new StreamDelay(STEADY_AFTER_S))
            .isLate(heartbeat, nowMicros, orderExpiryS());
    if (isLate && Long.bitCount(++lateHeartbeats) == 1) { // 1, 2, 4, 8…
      log(
          LogLevelEnum.WARN,
          String.format(
              Locale.ROOT,
              "ignored a heartbeat of \"%s\" (%d so far): it was held up by more than ORDER EXPIRY",
              heartbeat.operator(),
              lateHeartbeats));
    }
    return isLate;
  }

  private void onCondition(ServiceCondition condition) {
    conditions.see(condition);
    see(Channels.CONDITIONS, condition);
  }

  private void obey(ArmCommand command) {
    long now = clock().micros();
    String order = "\"" + command.operator() + "\" asks to " + (command.arm() ? "arm" : "disarm");
    Optional<String> late =
        command.arm() ? lateness(command).or(() -> earliness(command)) : Optional.empty();
    if (late.isEmpty() && command.arm() && !arming.isNew(command)) {
      ArmingState state = arming.state(now).requestId(command.requestId());
      publish(state.armed() ? state : state.reasons(List.of(REPEATED)));
      return;
    }
    if (late.isPresent()) {
      log(LogLevelEnum.WARN, order + ": refused, because " + late.get());
    } else {
      predecessor.end();
      decision.acknowledge();
      log(order);
      if (command.arm()) {
        arming.arm(now);
      } else {
        arming.disarm("by \"" + command.operator() + "\"");
      }
      save();
    }
    ArmingState state = arming.state(now).requestId(command.requestId());
    late.ifPresent(reason -> state.reasons(List.of(reason)));
    publish(state);
  }

  /** A predecessor that left no state may have obeyed it, and the vehicle been disarmed since. */
  private Optional<String> earliness(ArmCommand command) {
    return !knowsOrders && command.timestamp().orElse(beganMicros) < beganMicros
        ? Optional.of("the order was given before the Safety Manager was restarted: give it again")
        : Optional.empty();
  }

  private void onFenceOrder(U2SAData message) {
    if (!(message instanceof FenceOrder order)) {
      return; // a result
    }
    boolean armed = begun ? arming.isArmed() : predecessor.wasArmed();
    FenceOrderResult result = fenceOrders.obey(order, getServiceName(), armed, clock().micros());
    log(
        result.accepted() ? LogLevelEnum.INFO : LogLevelEnum.WARN,
        "fence: " + order.action() + " by \"" + order.operator() + "\": " + result.outcome());
    publishFence();
    publish(Channels.FENCE_ORDERS, result);
  }

  private void onFenceBefore(FenceState before) {
    if (begun || !predecessor.isStateLost()) {
      return; // its own
    }
    try {
      if (fenceWatch.resume(before)) {
        log(LogLevelEnum.WARN, "fence of " + before.file().orElse("") + " still in force");
      }
    } catch (BadInputException e) {
      trouble("the fence in force before the restart is lost: " + e.getMessage());
    }
  }

  private void onFailsafeBefore(FailsafeState before) {
    if (!begun) {
      failsafeBefore = before;
    }
  }

  private void publishFence() {
    if (saidFence != fenceWatch.changes()) {
      saidFence = fenceWatch.changes();
      publish(Channels.FENCE, fenceWatch.state());
      save();
    }
  }

  private void stopOrGo(EmergencyStop message) {
    Optional<String> late = message.active() || !begun ? Optional.empty() : lateness(message);
    if (late.isPresent() && emergency.isStopped()) {
      stopAgain(message, late.get());
      return;
    }
    boolean changed = emergency.accept(message);
    if (!message.active()) {
      lastClearMicros = message.timestamp().orElse(0L);
      lastClear = message.operator() + " " + lastClearMicros;
    }
    heedsEmergencyStops(emergency.identities());
    if (!message.active() && emergency.isStopped()) {
      // The clear is retained: late subscribers must not conclude that the remaining stops ended.
      publish(Channels.EMERGENCY_STOP, emergency.stop().orElseThrow());
      giveAgain(emergency.spared());
    }
    if (!changed) {
      return;
    }
    if (emergency.isStopped()) {
      arming.disarm("emergency stop by \"" + message.operator() + "\": " + message.reason());
    } else {
      log("emergency stop cleared by \"" + message.operator() + "\"");
      decision.acknowledge();
      publish(Channels.EMERGENCY_STOP, message); // a repeated stop may have overtaken it
    }
    save();
    publish(arming.state(clock().micros()));
  }

  private void stopAgain(EmergencyStop clear, String why) {
    log(
        LogLevelEnum.WARN,
        "emergency stop not cleared by \"" + clear.operator() + "\", because " + why);
    giveAgain(emergency.stops());
    save();
  }

  /** For services that a clear has freed: with another timestamp a stop counts as a new one. */
  private void giveAgain(List<EmergencyStop> stops) {
    for (EmergencyStop stop : stops) {
      publish(Channels.EMERGENCY_STOP, emergency.renew(stop));
    }
    heedsEmergencyStops(emergency.identities());
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    if (!begun) {
      if (predecessor.isAwaited(now)) {
        return;
      }
      beginAfterPredecessor();
    }
    boolean repeat = nowS >= repeatDueS;
    if (repeat) {
      repeatDueS = nowS + REPEAT_INTERVAL_S;
    }
    publishFence();
    if (arming.isArmed()) {
      decide(now);
    } else if (!emergency.isStopped()) {
      arming.armAtStart(now);
    }
    save();
    FailsafeAction action = action();
    if (repeat || action != said || !decision.hazards().equals(saidHazards)) {
      publishFailsafe(action);
    }
    if (repeat || arming.hasChanged(now)) {
      publish(arming.state(now));
    }
    if (repeat) {
      emergency.stops().forEach(stop -> publish(Channels.EMERGENCY_STOP, stop)); // newest last
    }
  }

  private void decide(long now) {
    boolean waits = pilot.flies(now);
    if (pilot.isHeard(now)) {
      watches.forEach(watch -> watch.pilotFlies(now));
    }
    for (Watch watch : watches) {
      watch
          .trouble(now)
          .ifPresent(
              words -> {
                if (waits) {
                  decision.report(watch.hazard(), words, now);
                } else {
                  decision.present(watch.hazard(), words, now);
                }
              });
    }
    decision.forgetUntil(now);
    if (decision.action() == FailsafeAction.STOP) {
      EmergencyStop stop =
          new EmergencyStop()
              .active(true)
              .stopId(getServiceName() + " " + now)
              .operator(getServiceName())
              .reason(String.join("; ", decision.causes()));
      publish(Channels.EMERGENCY_STOP, stop);
      stopOrGo(stop);
    }
  }

  private FailsafeAction action() {
    if (emergency.isStopped()) {
      return FailsafeAction.STOP;
    }
    return arming.isArmed() ? decision.action() : FailsafeAction.CONTINUE;
  }

  private void publishFailsafe(FailsafeAction action) {
    List<String> causes =
        action == FailsafeAction.CONTINUE && !arming.isArmed() ? List.of() : decision.causes();
    publish(new FailsafeState().action(action).causes(causes));
    if (action != said || !decision.hazards().equals(saidHazards)) {
      said = action;
      boolean isOrdered = causes.isEmpty() && emergency.isStopped();
      saidHazards = decision.hazards();
      log(
          action == FailsafeAction.CONTINUE ? LogLevelEnum.INFO : LogLevelEnum.WARN,
          "failsafe " + action + " because of " + (isOrdered ? "a stop order" : causes));
    }
  }
}
