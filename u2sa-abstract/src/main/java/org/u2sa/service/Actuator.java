package org.u2sa.service;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.actuator.ActuatorDescription;
import org.u2sa.service.actuator.ActuatorOwner;
import org.u2sa.service.handover.HandOver;

/**
 * An actuator service (thesis 3.2.2.5), which goes neutral when commands expire, at an emergency
 * stop, and at the end. In: actuation (its own commands), emergency-stop, arming-state. Out:
 * actuators, its periodic announcement (thesis 5.1).
 */
public abstract class Actuator extends PeriodicService implements ActuatorOwner {
  private static final double EXPIRY_CHECKS_PER_S = 50.0;

  private record Names(
      @Variable(ifAbsentText = "")
          @Description(
              "Name to which commands are addressed, unique in the system; empty: the service's name.")
          String actuatorName) {}

  private final String actuatorName;
  private final ActuatorDescription description;
  private final CommandedActuators commands;
  private boolean neutral;

  /** See {@link U2SAService#U2SAService}. */
  protected Actuator(ServiceContext context, String serviceName) {
    super(context, ServiceRole.ACTUATOR, serviceName, EXPIRY_CHECKS_PER_S);
    String configured = settings(Names.class).get().actuatorName();
    actuatorName = configured.isEmpty() ? getServiceName() : configured;
    description = settings(ActuatorDescription.class).get();
    commands = new CommandedActuators(this, Set.of(actuatorName), this::obey, this::goNeutral);
  }

  /** Applies a command [%], −100…100. Called on the service's thread for each command. */
  protected abstract void actuate(double percentage);

  /** Moves to the neutral, safe position. */
  protected abstract void neutral();

  /** Closes the device, after {@link #neutral}. */
  protected void close() {}

  /** The announcement from the configuration; subclasses refine it. */
  protected ActuatorAnnouncement announcement() {
    return description.addTo(
        new ActuatorAnnouncement().actuatorName(actuatorName).minimum(-100.0).maximum(100.0));
  }

  @Override
  public final List<ActuatorAnnouncement> actuators() {
    return List.of(announcement());
  }

  /**
   * Announces the remaining effectiveness [%, 0…100], 0 if the device is lost; only after the
   * start.
   */
  protected final void available(double percent) {
    commands.available(actuatorName, percent);
  }

  /** The command in effect, as sent: possibly an angle, speed or force. */
  protected final Optional<ActuatorCommand> command() {
    return commands.command(actuatorName);
  }

  @Override
  protected final void begin() {
    // first, because this class's limits differ from the predecessor's
    commands.announce(actuators());
    if (commands.isCommanded()) {
      carryOut();
    } else {
      neutral();
      neutral = true;
    }
  }

  private void obey() {
    neutral = false;
    carryOut();
  }

  @Override
  protected final void step(double nowS) {
    if (commands.percentage(actuatorName).isEmpty()) {
      goNeutral();
    }
    commands.step(nowS);
  }

  private void carryOut() {
    OptionalDouble percentage = commands.percentage(actuatorName);
    if (percentage.isPresent()) {
      actuate(percentage.getAsDouble());
    } else {
      goNeutral();
    }
  }

  /** Acts before it logs, and again with the next step if the device fails. */
  private void goNeutral() {
    if (!neutral) {
      neutral();
      neutral = true;
      commands.reportStops(); // which a failure before this kept from being confirmed
      log(
          LogLevelEnum.WARN,
          commands.mayMove()
              ? "command expired: going neutral"
              : "movement not allowed: going neutral");
    }
  }

  /** {@inheritDoc} Overriding methods must call this one. */
  @Override
  protected void handOver(HandOver state) {
    commands.handOver(state);
  }

  /** {@inheritDoc} Overriding methods must call this one. */
  @Override
  protected void takeOver(HandOver state) {
    commands.takeOver(state);
  }

  @Override
  protected final void release() {
    try {
      neutral();
    } finally {
      commands.withdraw();
      close();
    }
  }

  @Override
  protected final void releaseToSuccessor() {
    close();
  }

  /** Name to which commands are addressed. */
  public final String actuatorName() {
    return actuatorName;
  }
}
