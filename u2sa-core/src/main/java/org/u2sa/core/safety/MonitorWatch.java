package org.u2sa.core.safety;

import java.util.Optional;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.U2SAData;

/** Whether the health monitor is there: nobody else watches the watcher. */
final class MonitorWatch implements Watch {
  private final Configurator configuration;
  private long heardMicros = -1;

  MonitorWatch(Configurator configuration) {
    this.configuration = configuration;
    configuration.getVariable(SafetyVariables.MONITOR_SERVICE);
    configuration.getVariable(SafetyVariables.MONITOR_DEADLINE);
    configuration.getVariable(SafetyVariables.MONITOR_REQUIRED);
  }

  @Override
  public Hazard hazard() {
    return Hazard.HEALTH_MONITOR;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    if (message instanceof HealthReport report
        && report.status() == ServiceStatus.RUNNING
        && report.serviceName().equals(name())) {
      heardMicros = nowMicros;
    }
  }

  private String name() {
    return configuration.getVariable(SafetyVariables.MONITOR_SERVICE);
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    if (heardMicros < 0) {
      return configuration.getVariable(SafetyVariables.MONITOR_REQUIRED)
          ? Optional.of("no " + name() + " was heard")
          : Optional.empty();
    }
    double silentS = Clock.seconds(nowMicros - heardMicros);
    return silentS > configuration.getVariable(SafetyVariables.MONITOR_DEADLINE)
        ? Optional.of(name() + " silent for " + Words.seconds(silentS))
        : Optional.empty();
  }
}
