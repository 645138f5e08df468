package {{package}};

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class {{Name}}Test {
  @Test
  void mission_ofTheVehicle_isCompleted(@TempDir Path logs) throws InterruptedException {
    assertThat(Drive.completed("config/{{file}}/system.xml", logs, 3, 120.0))
        .containsExactly("north", "north-east", "east");
  }
}
