package org.u2sa.service;

import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.service.actuator.CommandHold;
import org.u2sa.service.actuator.CommandRefusal;
import org.u2sa.service.actuator.EmergencyLatch;
import org.u2sa.service.handover.HandOver;

/**
 * Gate between the actuation channel and the actuators of one service: invalid commands are
 * refused, counted and logged, and nothing moves while an emergency stop is active or, if REQUIRES
 * ARMING, while the vehicle is not armed. In: actuation, emergency-stop, arming-state.
 *
 * <p>{@link Actuator} has it built in; services with several actuators create one in their
 * constructor. Belongs to its service's thread.
 */
public final class CommandedActuators {
  private record Limits(
      @Variable(unit = "s", min = 0.01, max = 60, ifAbsent = 0.5)
          @Description("Time without a command after which an actuator goes neutral.")
          double commandExpiry,
      @Variable(unit = "s", min = 0, max = 60, ifAbsent = 1)
          @Description(
              "Maximum time by which a command's timestamp may be ahead of this clock; later ones are refused.")
          double clockTolerance,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether actuators obey only while a Safety Manager reports that the vehicle is armed.")
          boolean requiresArming,
      // The longest measured restart or outage took 7.5 s, after which it listens for 0.5 s.
      @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 10)
          @Description(
              "Time without an arming state after which a vehicle that requires arming counts as disarmed; 0: never, for a vehicle that would fall from the air.")
          double armingExpiry) {}

  private static final String COMMANDS = "ACTUATOR COMMANDS";
  private static final String ARMED = "ARMED";
  private static final Range ANY_PERCENTAGE = Range.of(-100.0, 100.0);
  private static final double ANNOUNCE_EVERY_S = 5.0;
  private static final double ALL_PERCENT = 100.0;

  /** Several times the interval at which a Safety Manager repeats its state. */
  private static final long MAX_ARMED_AGE_MICROS = 5 * Clock.MICROS_PER_SECOND;

  private final U2SAService service;
  private final Settings<Limits> limits;
  private final CommandHold commands;
  private final EmergencyLatch emergency;
  private final Runnable stopped;
  private final Map<CommandRefusal, Long> refusals = new EnumMap<>(CommandRefusal.class);
  private final Map<String, ActuatorAnnouncement> announcements = new LinkedHashMap<>();
  private double announceEveryS = ANNOUNCE_EVERY_S;
  private double announceDueS = Double.POSITIVE_INFINITY;
  private BooleanSupplier deviceStopped = () -> true;
  private boolean isWithheldByRadio;
  private boolean unconfirmed; // stopped, but not yet confirmed by the device
  private boolean armed;
  private long armedMicros; // time at which that was last received
  private boolean ignoresArmed; // the last state, for its age

  /**
   * Declares its variables with the service and subscribes for it.
   *
   * @param names actuator names to which commands are addressed
   * @param stopped called immediately on a stop or disarming, without waiting for the next step
   */
  public CommandedActuators(U2SAService service, Set<String> names, Runnable stopped) {
    this(service, names, () -> {}, stopped);
  }

  /**
   * @param commanded called when an actuator has a new percentage
   */
  CommandedActuators(U2SAService service, Set<String> names, Runnable commanded, Runnable stopped) {
    this.service = service;
    this.stopped = stopped;
    limits = service.settings(Limits.class);
    String systemId = service.context().systemId();
    Map<String, Range> ranges = new LinkedHashMap<>();
    names.forEach(name -> ranges.put(name, ANY_PERCENTAGE));
    commands =
        new CommandHold(
            service.clock(),
            systemId,
            limits.get().commandExpiry(),
            limits.get().clockTolerance(),
            ranges);
    emergency = new EmergencyLatch(service.clock(), systemId);
    service.health.hasActuators();
    service.heedsEmergencyStops(emergency.identities());
    service.registerPublisher(Channels.ACTUATORS);
    service.registerPublisher(Channels.EMERGENCY_STOP);
    service.subscribe(Channels.EMERGENCY_STOP, this::stopOrGo); // first: before any command
    service.subscribe(Channels.ARMING_STATE, this::arm);
    service.subscribe(
        Channels.ACTUATION,
        command -> {
          Optional<CommandRefusal> refusal = refusal(command);
          if (refusal.isPresent()) {
            refuse(command, refusal.get());
          } else {
            service.health.obeyed();
            commanded.run();
          }
        });
  }

  /**
   * Delays the confirmation of emergency stops for a device that can show that it has received one.
   * None is confirmed while all actuators are unavailable, as those of a lost device.
   *
   * @param stopped whether the device has received the newest stop; asked after the stop was
   *     commanded, and in each {@link #step} until it has
   */
  public void confirmStopsWhen(BooleanSupplier stopped) {
    deviceStopped = stopped;
  }

  /**
   * Announces the actuators to control systems, now and at the shortest renewal period of any of
   * them, because a late subscriber receives the last announcement only. Commands that were not
   * announced are refused.
   */
  public void announce(List<ActuatorAnnouncement> actuators) {
    announcements.clear();
    announceEveryS = ANNOUNCE_EVERY_S;
    for (ActuatorAnnouncement each : actuators) {
      each.serviceName(service.getServiceName());
      commands.limit(each);
      announcements.put(each.actuatorName(), each);
      announceEveryS = Math.min(announceEveryS, each.renewal().orElse(ANNOUNCE_EVERY_S));
    }
    announceNow();
  }

  /**
   * Renews a due announcement, and disarms if the Safety Manager is silent; call it in each step.
   */
  public void step(double nowS) {
    expireArming();
    if (unconfirmed) {
      reportStops();
    }
    announceWithheld();
    if (nowS >= announceDueS) {
      announceDueS = nowS + announceEveryS;
      announcements.values().forEach(each -> service.publish(Channels.ACTUATORS, each.copy()));
    }
  }

  private void announceNow() {
    announceDueS = Double.NEGATIVE_INFINITY;
    step(service.nowS());
  }

  /**
   * Announces the remaining effectiveness of an actuator if it has changed.
   *
   * @param percent 0 for a lost actuator, 100 for a healthy one
   * @throws IllegalArgumentException if no such actuator was announced
   */
  public void available(String actuator, double percent) {
    ActuatorAnnouncement announced = announcements.get(actuator);
    if (announced == null) {
      throw new IllegalArgumentException("actuator \"" + actuator + "\" was not announced");
    }
    if (announced.available().orElse(ALL_PERCENT) != percent) {
      announced.available(percent);
      announceNow();
    }
  }

  /** Announces the position that an actuator has taken [%], unless the actuator is unannounced. */
  public void hasTaken(String actuator, double percent) {
    ActuatorAnnouncement announced = announcements.get(actuator);
    if (announced != null) {
      announced.percentage(percent);
      announceNow();
    }
  }

  /** {@link #available(String, double)} of all actuators, which share a device. */
  public void available(double percent) {
    boolean changes = false;
    for (ActuatorAnnouncement announced : announcements.values()) {
      changes |= announced.available().orElse(ALL_PERCENT) != percent;
      announced.available(percent);
    }
    if (changes) {
      announceNow();
    }
  }

  /**
   * Whether commands are withheld from the actuators because a pilot's radio has precedence;
   * announced in the next step, as emergency stops are.
   */
  public void withheld(boolean byRadio) {
    isWithheldByRadio = byRadio;
  }

  private void announceWithheld() {
    boolean isWithheld = isWithheldByRadio || emergency.isStopped();
    boolean changes = false;
    for (ActuatorAnnouncement announced : announcements.values()) {
      if (announced.withheld() != isWithheld) {
        announced.withheld(isWithheld);
        changes = true;
      }
    }
    if (changes) {
      announceDueS = Double.NEGATIVE_INFINITY;
    }
  }

  /** Announces that the actuators are gone; call it in the service's release. */
  public void withdraw() {
    available(0.0);
  }

  private Optional<CommandRefusal> refusal(ActuatorCommand command) {
    Optional<CommandRefusal> wrong = commands.accept(command);
    if (mayMove() || wrong.filter(CommandRefusal.NOT_ADDRESSED::equals).isPresent()) {
      return wrong;
    }
    commands.forget();
    return Optional.of(
        emergency.isStopped() ? CommandRefusal.EMERGENCY_STOPPED : CommandRefusal.NOT_ARMED);
  }

  private void refuse(ActuatorCommand command, CommandRefusal reason) {
    long count = refusals.merge(reason, 1L, Long::sum);
    if (reason == CommandRefusal.NOT_ADDRESSED) {
      return; // all actuators share the channel
    }
    service.health.refused();
    if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
      service.log(
          LogLevelEnum.WARN, "refused " + command + ": " + reason + " (" + count + " so far)");
    }
  }

  /** Acts first: a log on a disk that hangs must not delay it. */
  private void stopOrGo(EmergencyStop message) {
    boolean changed = emergency.accept(message);
    if (changed) {
      commands.forget();
    }
    stopUnlessItMayMove();
    reportStops();
    if (!message.active()) {
      repeatWhatHolds(message);
    }
    if (changed) {
      boolean stopped = emergency.isStopped();
      service.log(
          stopped ? LogLevelEnum.WARN : LogLevelEnum.INFO,
          String.format(
              "%s by \"%s\": %s",
              stopped ? "emergency stop" : "emergency stop cleared",
              message.operator(),
              message.reason()));
    }
  }

  public boolean isStopped() {
    return emergency.isStopped();
  }

  void reportStops() {
    unconfirmed = emergency.isStopped() && (isDeviceLost() || !deviceStopped.getAsBoolean());
    if (!unconfirmed) {
      service.heedsEmergencyStops(emergency.identities());
    }
  }

  /** A device behind a link that hangs may go on with its last commands. */
  private boolean isDeviceLost() {
    return !announcements.isEmpty()
        && announcements.values().stream()
            .allMatch(each -> each.available().orElse(ALL_PERCENT) <= 0.0);
  }

  private void stopUnlessItMayMove() {
    if (!mayMove()) {
      stopped.run();
    }
  }

  /**
   * A clear is retained: a late subscriber must not mistake it for the end of a stop it does not
   * cover.
   */
  private void repeatWhatHolds(EmergencyStop clear) {
    Optional<EmergencyStop> holding = emergency.stop();
    if (holding.isPresent()) {
      service.log(
          LogLevelEnum.WARN,
          "clear by \"" + clear.operator() + "\" leaves " + holding.get() + ": still stopped");
      service.publish(Channels.EMERGENCY_STOP, holding.get());
    }
  }

  private void arm(ArmingState state) {
    boolean isIgnored = state.armed() && isOld(state);
    boolean isNewlyIgnored = isIgnored && !ignoresArmed;
    ignoresArmed = isIgnored;
    if (isNewlyIgnored) {
      warnOfOldState();
    }
    if (isIgnored && armed) {
      return; // a delayed message neither disarms nor proves that a Safety Manager still works
    }
    boolean isArmed = state.armed() && !isIgnored;
    boolean changed = isArmed != armed;
    armed = isArmed;
    armedMicros = service.clock().micros();
    if (changed && !mayMove()) {
      commands.forget();
    }
    stopUnlessItMayMove();
    if (changed) {
      service.log(armed ? "armed" : "disarmed: " + state.reasons());
    }
  }

  private void warnOfOldState() {
    service.log(
        LogLevelEnum.WARN,
        "ignored an armed state: sent more than "
            + MAX_ARMED_AGE_MICROS / Clock.MICROS_PER_SECOND
            + " s ago, by an earlier run or a clock that is behind");
  }

  private void expireArming() {
    double expiryS = limits.get().armingExpiry();
    double silentS = Clock.seconds(service.clock().micros() - armedMicros);
    if (armed && limits.get().requiresArming() && expiryS > 0.0 && silentS > expiryS) {
      armed = false;
      commands.forget();
      stopped.run();
      service.log(
          LogLevelEnum.WARN,
          "no arming state for " + expiryS + " s: disarmed until a Safety Manager reports armed");
    }
  }

  /** Whether a state retained by a broker is from an earlier run. */
  private boolean isOld(ArmingState state) {
    long now = service.clock().micros();
    return now - state.timestamp().orElse(now) > MAX_ARMED_AGE_MICROS;
  }

  /** Whether no emergency stop is active, and the vehicle is armed if required. */
  public boolean mayMove() {
    return !emergency.isStopped() && (armed || !limits.get().requiresArming());
  }

  /**
   * Whether a Safety Manager has reported the vehicle armed within ARMING EXPIRY; whether or not
   * REQUIRES ARMING.
   */
  public boolean isArmed() {
    double expiryS = limits.get().armingExpiry();
    double silentS = Clock.seconds(service.clock().micros() - armedMicros);
    return armed && (expiryS <= 0.0 || silentS <= expiryS);
  }

  /** Current command [%], −100…100; empty for neutral: expired, stopped, or not armed. */
  public OptionalDouble percentage(String actuator) {
    return mayMove() ? commands.percentage(actuator) : OptionalDouble.empty();
  }

  /**
   * Current command as sent, for services that use an angle, speed or force; empty if {@link
   * #percentage} is.
   */
  public Optional<ActuatorCommand> command(String actuator) {
    return mayMove() ? commands.command(actuator) : Optional.empty();
  }

  /** Whether any of these actuators has an unexpired command. */
  public boolean isCommanded() {
    return mayMove() && !commands.standing().isEmpty();
  }

  /**
   * Saves the unexpired commands with their remaining lifetimes, the stops and the arming state.
   */
  public void handOver(HandOver state) {
    emergency.handOver(state);
    state.flag(ARMED, armed).messages(COMMANDS, commands.standing());
  }

  /**
   * Restores the saved state, so that no actuator moves because of the swap. Commands this service
   * would refuse are dropped.
   */
  public void takeOver(HandOver state) {
    armed = state.flag(ARMED);
    armedMicros = service.clock().micros();
    emergency.takeOver(state);
    service.heedsEmergencyStops(emergency.identities());
    if (mayMove()) {
      state.messages(COMMANDS, ActuatorCommand.class).forEach(commands::accept);
    }
  }

  public long refused(CommandRefusal reason) {
    return refusals.getOrDefault(reason, 0L);
  }
}
