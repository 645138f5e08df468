package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.safety.EmergencyStop;

/** An emergency stop outlives actuator, Safety Manager and broker. */
@Timeout(180)
class EmergencyStopRestartTest extends StoppedBoat {
  @Test
  void stop_actuatorStartsAnew_itIsStoppedUntilCleared() {
    Motor before = startMotor();
    EmergencyStop stop = stop(before);
    end(before);

    Motor again = startMotor();

    requireStoppedUntilCleared(again, stop);
  }

  @Test
  void stop_brokerThenActuatorStartAnew_theSafetyManagerStillKnows() {
    started(new SafetyManager(context("SafetyManager", Map.of())));
    Motor before = startMotor();
    EmergencyStop stop = stop(before);

    awaitKnown(0);
    startBrokerAnewWithoutTheOperator();

    requireStopped(before);
    end(before);
    Motor again = startMotor();
    requireStoppedUntilCleared(again, stop);
  }

  @Test
  void stop_safetyManagerStartsAnew_itHoldsOnToIt() {
    SafetyManager first = started(new SafetyManager(context("SafetyManager", Map.of())));
    Motor motor = startMotor();
    EmergencyStop stop = stop(motor);
    end(first);

    long startedMicros = new SystemClock().micros();
    SafetyManager second = started(new SafetyManager(context("SafetyManager", Map.of())));
    awaitKnown(startedMicros);
    startBrokerAnewWithoutTheOperator();
    end(motor);
    Motor again = startMotor();

    requireStoppedUntilCleared(again, stop);
    assertThat(second.isRunning()).isTrue();
  }
}
