package org.u2sa.core.safety;

import java.util.Optional;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.OperatorHeartbeat;
import org.u2sa.messages.schema.U2SAData;

/** The link to whoever watches the vehicle: lost when no operator has been heard for a time. */
final class OperatorWatch implements Watch {
  private final Configurator configuration;
  private String operator = "";
  private long heardMicros = -1; // by this clock: an operator's own may differ

  OperatorWatch(Configurator configuration) {
    this.configuration = configuration;
    configuration.getVariable(SafetyVariables.OPERATOR_DEADLINE);
    configuration.getVariable(SafetyVariables.OPERATOR_REQUIRED);
  }

  @Override
  public Hazard hazard() {
    return Hazard.OPERATOR;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    if (message instanceof OperatorHeartbeat heartbeat) {
      operator = heartbeat.operator();
      heardMicros = nowMicros;
    }
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    if (heardMicros < 0) {
      return configuration.getVariable(SafetyVariables.OPERATOR_REQUIRED)
          ? Optional.of("no operator was heard")
          : Optional.empty();
    }
    double silentS = Clock.seconds(nowMicros - heardMicros);
    return silentS > configuration.getVariable(SafetyVariables.OPERATOR_DEADLINE)
        ? Optional.of("\"" + operator + "\" silent for " + Words.seconds(silentS))
        : Optional.empty();
  }
}
