package org.u2sa.service;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.u2sa.interfaces.configuration.ChangeOrigin;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.log.LogFile;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.log.Logger;
import org.u2sa.interfaces.time.Clock;

/**
 * The part of a service that has a name, a configuration file and a log file (thesis 3.2.1.1,
 * 3.2.1.5).
 */
abstract class ConfiguredService extends Thread implements Logger {
  private final ServiceContext context;
  private final XmlConfiguration configuration;
  private final LogFile logFile;

  ConfiguredService(ServiceContext context, String serviceName) {
    this.context = context;
    configuration = context.configuration();
    String configuredName = configuration.getVariable(ServiceVariables.SERVICE_NAME);
    Optional<U2SAService> before = context.predecessor();
    String ownName = ServiceName.checked(configuredName.isEmpty() ? serviceName : configuredName);
    setName(before.map(U2SAService::getServiceName).orElse(ownName));
    String configuredPath = configuration.getVariable(ServiceVariables.LOG_PATH);
    Path directory = configuredPath.isEmpty() ? context.logDirectory() : Paths.get(configuredPath);
    LogLevelEnum lowest =
        LogLevelEnum.valueOf(configuration.getVariable(ServiceVariables.LOG_LEVEL));
    if (before.isPresent()) {
      logFile = before.get().logFile(); // goes on in the same file
    } else {
      logFile =
          new LogFile(directory.resolve(getName() + ".log"), getName(), lowest, context.clock());
      context.onAbandon(logFile::close);
    }
  }

  @Override
  public final Object getVariable(String variableName) {
    return configuration.getVariable(variableName);
  }

  @Override
  public final <T> T getVariable(Variable<T> variable) {
    return configuration.getVariable(variable);
  }

  @Override
  public final boolean setVariable(String variableName, Object value) {
    ChangeOrigin self = new ChangeOrigin(clock().micros(), getName(), getName());
    Optional<String> refusal =
        configuration
            .change(
                Collections.singletonMap(variableName, value),
                OptionalLong.empty(),
                self,
                this::configurationRefusal)
            .refusal();
    refusal.ifPresent(
        reason ->
            log(LogLevelEnum.ERROR, "variable \"" + variableName + "\" was not set: " + reason));
    return refusal.isEmpty();
  }

  /**
   * Why these values would not do together, though each is allowed; empty if they would. Asked
   * before a change or an undo is written, which is refused with this reason. May be asked from any
   * thread that calls {@link #setVariable}: judges its argument alone.
   *
   * @param values every variable of this service as it would be, in the declared units
   */
  protected Optional<String> configurationRefusal(Map<String, Object> values) {
    return Optional.empty();
  }

  @Override
  public final ArrayList<Map.Entry<String, Object>> enumerateFields() {
    return configuration.enumerateFields();
  }

  /** Writes a line of level INFO to the service's log file (thesis 8.2.3.1). */
  public final void log(String message) {
    log(LogLevelEnum.INFO, message);
  }

  @Override
  public final void log(LogLevelEnum level, String logMessage) {
    logFile.log(level, logMessage);
  }

  final LogFile logFile() {
    return logFile;
  }

  /** The name under which others find this service. */
  public final String getServiceName() {
    return getName();
  }

  /** What the service was given at its construction. */
  protected final ServiceContext context() {
    return context;
  }

  /** The time of the run. */
  protected final Clock clock() {
    return context.clock();
  }

  /** The time now [s] of the run's clock. */
  protected final double nowS() {
    return Clock.seconds(context.clock().micros());
  }
}
