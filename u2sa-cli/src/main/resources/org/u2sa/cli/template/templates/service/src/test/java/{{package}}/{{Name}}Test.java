package {{package}};

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.testkit.ServiceKit;

class {{Name}}Test {
  private final ServiceKit kit = new ServiceKit().with("NOISE", 0.2);

  @AfterEach
  void close() {
    kit.close();
  }

  @Test
  void run_withinASecond_publishesTenReadings() {
    kit.start({{Name}}::new);
    kit.forget();
    kit.advance(1.0);
    assertThat(kit.published(Channels.SENSED_STATE))
        .hasSize(10)
        .allSatisfy(state -> assertThat(state.z().orElseThrow()).isBetween(90.0, 110.0));
  }

  @Test
  void callback_stateFarFromTheReading_isLogged() {
    kit.start({{Name}}::new);
    kit.publish(Channels.STATE, new StateInformation().sensorName("estimate").z(500.0));
    assertThat(kit.log("{{Name}}")).anyMatch(line -> line.contains("is said to be at 500.0 m"));
  }

  @Test
  void kill_running_endsTheLoop() {
    {{Name}} service = kit.start({{Name}}::new);
    service.kill();
    kit.advance(0.3);
    assertThat(service.status()).isEqualTo(ServiceStatus.STOPPED);
  }
}
