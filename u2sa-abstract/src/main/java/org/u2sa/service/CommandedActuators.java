package org.u2sa.service;

import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.ActuatorCommand;
import org.u2sa.messages.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ArmingState;
import org.u2sa.messages.contract.EmergencyStop;
import org.u2sa.messages.schema.U2SAData;

/**
 * What stands between the actuation channel and the actuators of one service: commands that must
 * not be obeyed are refused, counted and said, and nothing moves while an emergency stop holds or,
 * if REQUIRES ARMING, while the vehicle is not armed. In: actuation, emergency-stop, arming-state.
 *
 * <p>{@link Actuator} has it built in; services that own several actuators make one in their
 * constructor and hand it what comes. Belongs to its service's thread.
 */
public final class CommandedActuators {
  private record Limits(
      @Variable(
              unit = "s",
              min = 0.01,
              max = 60,
              ifAbsent = 0.5,
              text = "Time without a command after which an actuator goes neutral.")
          double commandExpiry,
      @Variable(
              unit = "s",
              min = 0,
              max = 60,
              ifAbsent = 1,
              text = "How far ahead of this clock a command's time may be before it is refused.")
          double clockTolerance,
      @Variable(
              ifAbsentText = "false",
              text = "Whether actuators obey only while a Safety Manager says that it is armed.")
          boolean requiresArming) {}

  private static final String COMMANDS = "ACTUATOR COMMANDS";
  private static final String ARMED = "ARMED";
  private static final Range ANY_PERCENTAGE = Range.of(-100.0, 100.0);

  private final U2SAService service;
  private final Settings<Limits> limits;
  private final CommandHold commands;
  private final EmergencyLatch emergency;
  private final Map<CommandRefusal, Long> refusals = new EnumMap<>(CommandRefusal.class);
  private boolean armed;

  /**
   * Declares its variables with the service and registers for it.
   *
   * @param names to which commands are addressed
   */
  public CommandedActuators(U2SAService service, Set<String> names) {
    this.service = service;
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
    service.registerSubscriber(Channels.EMERGENCY_STOP); // first: a stop that holds comes before
    service.registerSubscriber(Channels.ARMING_STATE);
    service.registerSubscriber(Channels.ACTUATION); // … the first command
  }

  /** Tells control systems of an actuator, and from now on refuses what is outside its extents. */
  public void announce(ActuatorAnnouncement announcement) {
    commands.limit(
        announcement.actuatorName(), Range.of(announcement.minimum(), announcement.maximum()));
    service.publish(Channels.ACTUATORS, announcement);
  }

  /**
   * Takes a command, or refuses it.
   *
   * @return whether an actuator here has a new percentage
   */
  public boolean obey(ActuatorCommand command) {
    Optional<CommandRefusal> refusal = refusal(command);
    if (refusal.isEmpty()) {
      service.health.obeyed();
      return true;
    }
    refuse(command, refusal.get());
    return false;
  }

  /**
   * Takes note of an emergency stop or of arming.
   *
   * @return false if the message is of another kind
   */
  public boolean heed(U2SAData data) {
    if (data instanceof EmergencyStop stop) {
      stopOrGo(stop);
    } else if (data instanceof ArmingState state) {
      arm(state);
    } else {
      return false;
    }
    return true;
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
      return; // the channel is every actuator's
    }
    service.health.refused();
    if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
      service.log(
          LogLevelEnum.WARN, "refused " + command + ": " + reason + " (" + count + " so far)");
    }
  }

  private void stopOrGo(EmergencyStop message) {
    boolean changed = emergency.accept(message);
    service.heedsEmergencyStops(emergency.identities());
    if (!message.active()) {
      repeatWhatHolds(message);
    }
    if (changed) {
      boolean stopped = emergency.isStopped();
      service.log(
          stopped ? LogLevelEnum.WARN : LogLevelEnum.INFO,
          (stopped ? "emergency stop" : "emergency stop cleared")
              + " by \""
              + message.operator()
              + "\": "
              + message.reason());
      commands.forget();
    }
  }

  /** A clear is retained: who comes late must not take it for the end of a stop that it left. */
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
    if (state.armed() != armed) {
      armed = state.armed();
      service.log(armed ? "armed" : "disarmed: " + state.reasons());
      if (!mayMove()) {
        commands.forget();
      }
    }
  }

  /** Whether actuators may move: no emergency stop holds, and it is armed if it must be. */
  public boolean mayMove() {
    return !emergency.isStopped() && (armed || !limits.get().requiresArming());
  }

  /**
   * The percentage that an actuator should hold now, −100…100; empty if it is to be neutral:
   * without a command in time, stopped, or not armed.
   */
  public OptionalDouble percentage(String actuator) {
    return mayMove() ? commands.percentage(actuator) : OptionalDouble.empty();
  }

  /** Whether some actuator here has a command that holds. */
  public boolean isCommanded() {
    return mayMove() && !commands.standing().isEmpty();
  }

  /**
   * Writes down the commands that hold, with the time that is left of them, the stops, and whether
   * it is armed; to be called in the service's {@link U2SAService#handOver}.
   */
  public void handOver(HandOver state) {
    emergency.handOver(state);
    state.flag(ARMED, armed).messages(COMMANDS, commands.standing());
  }

  /**
   * Goes on from what {@link #handOver} wrote, so that no actuator moves because of the swap; to be
   * called in the service's {@link U2SAService#takeOver}. What this service would refuse it does
   * not take over.
   */
  public void takeOver(HandOver state) {
    armed = state.flag(ARMED);
    emergency.takeOver(state);
    service.heedsEmergencyStops(emergency.identities());
    if (mayMove()) {
      state.messages(COMMANDS, PercentageCommand.class).forEach(commands::accept);
    }
  }

  /** Commands refused for that reason so far. */
  public long refused(CommandRefusal reason) {
    return refusals.getOrDefault(reason, 0L);
  }
}
