package {{package}};

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.testkit.ServiceKit;

class {{Name}}Test {
  private final List<Double> pulses = new ArrayList<>();
  private final ServiceKit kit = new ServiceKit().with("ACTUATOR NAME", "{{NAME}}");

  @AfterEach
  void close() {
    kit.close();
  }

  private double lastPulse() {
    return pulses.get(pulses.size() - 1);
  }

  @Test
  void actuate_halfPower_movesTheServo() {
    kit.start(context -> new {{Name}}(context, pulses::add));
    kit.publish(Channels.ACTUATION, PercentageCommand.of("{{NAME}}", 50.0));
    assertThat(lastPulse()).isEqualTo(1750.0);
  }

  @Test
  void actuate_commandOfAnother_staysNeutral() {
    kit.start(context -> new {{Name}}(context, pulses::add));
    kit.publish(Channels.ACTUATION, PercentageCommand.of("ANOTHER", 50.0));
    assertThat(lastPulse()).isEqualTo(1500.0);
  }

  @Test
  void step_withoutFurtherCommands_goesNeutral() {
    kit.start(context -> new {{Name}}(context, pulses::add));
    kit.publish(Channels.ACTUATION, PercentageCommand.of("{{NAME}}", 50.0));
    kit.advance(1.0); // longer than COMMAND EXPIRY
    assertThat(lastPulse()).isEqualTo(1500.0);
  }
}
