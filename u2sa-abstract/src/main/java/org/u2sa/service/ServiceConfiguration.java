package org.u2sa.service;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.regex.Pattern;
import org.u2sa.interfaces.configuration.ChangeOrigin;
import org.u2sa.interfaces.configuration.ConfigurationCheck;
import org.u2sa.interfaces.configuration.ConfigurationException;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.log.LogFile;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.units.NumberText;
import org.u2sa.messages.schema.U2SAData;

/** A service's name, variables, clock and log file (thesis 3.2.1.1, 3.2.1.5). */
final class ServiceConfiguration {
  private static final double MIN_EXPIRY_S =
      1.0; // less would refuse every order, even one to raise it

  /** Validates service names, which are also names of log files and MQTT clients. */
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_][A-Za-z0-9 _.-]{0,63}");

  private final XmlConfiguration variables;
  private final ServiceVariables own;
  private final Clock clock;
  private final Execution execution;
  private final String name;
  private final LogFile log;

  ServiceConfiguration(ServiceContext context, String className) {
    variables = context.configuration();
    clock = context.clock();
    execution = context.execution();
    own = variables.settings(ServiceVariables.class).get();
    Optional<ServiceInstance> before = context.predecessor();
    String ownName = checkedName(own.serviceName().isEmpty() ? className : own.serviceName());
    String repeated =
        execution.inheritance().map(Execution.Inheritance::serviceName).orElse(ownName);
    name = before.map(ServiceInstance::getServiceName).orElse(repeated);
    boolean isNamed = !own.logPath().isEmpty() && execution.writesNamedFiles();
    Path directory = isNamed ? Paths.get(own.logPath()) : context.logDirectory();
    if (before.isPresent()) {
      log = before.get().logForSuccessor(clock);
    } else {
      log = new LogFile(directory.resolve(name + ".log"), name, own.logLevel(), clock);
      context.onAbandon(log::close);
    }
  }

  /**
   * @throws ConfigurationException if the name is invalid; names the variable that sets it
   */
  static String checkedName(String name) {
    if (!NAME.matcher(name).matches()) {
      throw new ConfigurationException(
          String.format(
              "service name \"%s\" (variable \"SERVICE NAME\"): expected 1 to 64 letters, digits, spaces, '_', '.' or '-', beginning with a letter, digit or '_'",
              name));
    }
    return name;
  }

  String name() {
    return name;
  }

  XmlConfiguration variables() {
    return variables;
  }

  /** Initial values. */
  ServiceVariables settings() {
    return own;
  }

  Clock clock() {
    return clock;
  }

  /** Age beyond which orders are ignored [s]; 0: never. */
  double orderExpiryS() {
    return own.orderExpiry() == 0.0 ? 0.0 : Math.max(MIN_EXPIRY_S, own.orderExpiry());
  }

  /** Reason for not obeying an order; see {@link U2SAService#lateness}. */
  Optional<String> lateness(U2SAData order) {
    long now = clock.micros();
    double ageS = Clock.seconds(now - order.timestamp().orElse(now));
    return orderExpiryS() == 0.0 || ageS <= orderExpiryS()
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT,
                "the order arrived %.1f s after it was given; expected at most ORDER EXPIRY, %s s: give it again (if it was given just now, the clocks differ)",
                ageS,
                NumberText.of(orderExpiryS())));
  }

  /** Hook of a recorder or replay. */
  Execution execution() {
    return execution;
  }

  LogFile log() {
    return log;
  }

  void log(LogLevelEnum level, String message) {
    log.log(level, message);
  }

  boolean setVariable(String variableName, Object value, ConfigurationCheck check) {
    ChangeOrigin self = new ChangeOrigin(clock.micros(), name, name);
    Optional<String> refusal =
        variables
            .change(
                Collections.singletonMap(variableName, value), OptionalLong.empty(), self, check)
            .refusal();
    refusal.ifPresent(
        reason ->
            log.log(
                LogLevelEnum.ERROR, "variable \"" + variableName + "\" was not set: " + reason));
    return refusal.isEmpty();
  }

  /** The common configuration variables of all services. */
  record ServiceVariables(
      @Variable(ifAbsentText = "")
          @Description(
              "Name of the service, unique within the system; empty: the default of its class.")
          String serviceName,
      @Variable(ifAbsentText = "")
          @Description("Directory of the log file; empty: the run's directory.")
          String logPath,
      @Variable(ifAbsentText = "INFO") @Description("Lowest level written to the log file.")
          LogLevelEnum logLevel,
      @Variable(name = "MAX ERRORS IN A ROW", min = 1, max = 1_000_000, ifAbsent = 10)
          @Description("Consecutive exceptions after which the service stops as failed.")
          int maxErrorsInARow,
      @Variable(unit = "s", min = 0.01, max = 3600, ifAbsent = 0.25)
          @Description("Time between two health reports.")
          double healthInterval,
      @Variable(min = 1, max = 1_000_000, ifAbsent = 1024)
          @Description(
              "Capacity of the service's message queue; messages beyond it are dropped and counted.")
          int inboxCapacity,
      @Variable(unit = "us", min = 0, max = 10_000, ifAbsent = 0)
          @Description(
              "Time for which the service spins (busy-waits) for the next message or step before it sleeps: lower latency for more CPU load. Real time only; 0: sleeps immediately.")
          double spin,
      @Variable(unit = "s", min = 0, max = 86_400, ifAbsent = 5)
          @Description(
              "Age at which an order (to arm, clear a stop, change mission, fence or variables, drive by hand) no longer counts: brokers keep orders while a link is down. Raise it for slow links; less than 1 s counts as 1 s; 0: orders count whenever they arrive. Needs a restart.")
          double orderExpiry) {}
}
