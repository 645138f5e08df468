package org.u2sa.service;

import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.interfaces.LogLevelEnum;
import org.u2sa.interfaces.Range;
import org.u2sa.interfaces.Variable;
import org.u2sa.messages.ActuatorCommand;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.ActuatorAnnouncement;

/**
 * A service that moves something (thesis 3.2.2.5). In: actuation, of which it obeys what is
 * addressed to its name. Out: actuators, its announcement (thesis 5.1).
 *
 * <p>When no command has come for the expiry time, and when the service ends, it goes neutral by
 * itself.
 */
public abstract class Actuator extends PeriodicService {
  private static final double EXPIRY_CHECKS_PER_S = 50.0;

  private static final Variable<String> ACTUATOR_NAME =
      Variable.text("ACTUATOR NAME")
          .ifAbsent("")
          .describedAs(
              "Name to which commands are addressed, unique in the system; empty: the service's name.");

  private static final Variable<Double> COMMAND_EXPIRY =
      Variable.number("COMMAND EXPIRY", "s")
          .range(Range.of(0.01, 60.0))
          .ifAbsent(0.5)
          .describedAs("Time without a command after which the actuator goes neutral.");

  private final String actuatorName;
  private final CommandHold commands;
  private boolean neutral;

  /** See {@link U2SAService#U2SAService}. */
  protected Actuator(ServiceContext context, String serviceName) {
    super(context, ServiceRole.ACTUATOR, serviceName, EXPIRY_CHECKS_PER_S);
    String configured = getVariable(ACTUATOR_NAME);
    actuatorName = configured.isEmpty() ? getServiceName() : configured;
    commands = new CommandHold(clock(), getVariable(COMMAND_EXPIRY), Set.of(actuatorName));
    registerPublisher(ActuatorAnnouncement.class);
    registerSubscriber(ActuatorCommand.class);
  }

  /** Moves to the percentage, −100…100. Called on the service's thread for each command. */
  protected abstract void actuate(double percentage);

  /**
   * Goes where nothing moves and nothing is harmed. Called when commands expire and when the
   * service ends.
   */
  protected abstract void neutral();

  /** Closes the device, after it was left {@link #neutral}. */
  protected void close() {}

  /**
   * What the actuator says of itself to control systems; subclasses add their effect and extents.
   */
  protected ActuatorAnnouncement announcement() {
    return new ActuatorAnnouncement().actuatorName(actuatorName).minimum(-100.0).maximum(100.0);
  }

  @Override
  protected final void begin() {
    neutral();
    neutral = true;
    publish(announcement());
  }

  @Override
  public final void callback(U2SAData data) {
    if (!(data instanceof ActuatorCommand command)) {
      unexpected(data);
    } else if (commands.accept(command)) {
      neutral = false;
      OptionalDouble percentage = commands.percentage(actuatorName);
      actuate(percentage.orElseThrow());
    } else if (command.actuatorName().equals(actuatorName)) {
      log(LogLevelEnum.WARN, "refused " + command + ": too old, or not a percentage");
    }
  }

  @Override
  protected final void step(double nowS) {
    if (!neutral && commands.percentage(actuatorName).isEmpty()) {
      log(LogLevelEnum.WARN, "no command in time: goes neutral");
      neutral = true;
      neutral();
    }
  }

  @Override
  protected final void release() {
    try {
      neutral();
    } finally {
      close();
    }
  }

  /** The name to which commands are addressed. */
  public final String actuatorName() {
    return actuatorName;
  }
}
