package {{package}};

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.testkit.ServiceKit;

class {{Name}}Test {
  @Test
  void control_pointToTheLeft_rightWheelTurnsFaster() {
    try (ServiceKit kit = new ServiceKit()) {
      kit.start({{Name}}::new);
      kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.of(1.0, 0.5, 0.0)));
      kit.publish(Channels.STATE, new StateInformation());
      assertThat(kit.percent("RIGHT MOTOR")).isGreaterThan(kit.percent("LEFT MOTOR"));
    }
  }

  @Test
  void control_withoutNavigation_stands() {
    try (ServiceKit kit = new ServiceKit()) {
      kit.start({{Name}}::new);
      kit.publish(Channels.STATE, new StateInformation());
      assertThat(kit.percent("LEFT MOTOR")).isZero();
      assertThat(kit.percent("RIGHT MOTOR")).isZero();
    }
  }

  @Test
  void mission_ofTheSimulatedRover_isCompleted(@TempDir Path logs) throws InterruptedException {
    assertThat(Drive.completed("config/{{file}}/system.xml", logs, 3, 120.0))
        .containsExactly("north", "north-east", "east");
  }
}
