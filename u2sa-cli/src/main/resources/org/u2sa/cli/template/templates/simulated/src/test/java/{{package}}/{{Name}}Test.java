package {{package}};

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.frame.Geodetic;

class {{Name}}Test {
  private static final Geodetic HOME = new Geodetic(10.0, 54.0, 0.0); // as in mission.xml

  @Test
  void mission_ofTheVehicle_isCompleted(@TempDir Path logs) throws InterruptedException {
    assertThat(SimulatedRun.completed(Path.of("config/{{file}}"), HOME, logs, 3, 300.0))
        .containsExactly("first", "second", "third");
  }
}
