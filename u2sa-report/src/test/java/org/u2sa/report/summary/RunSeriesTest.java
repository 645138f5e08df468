package org.u2sa.report.summary;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.report.score.SyntheticFlight;

class RunSeriesTest {

  @TempDir private Path directory;

  @Test
  void write_oneRunOfTwoFailed_tellsTheWorst() throws IOException {
    RunReport whole = SyntheticFlight.report(10);
    RunReport cutShort = SyntheticFlight.report(5);
    RunSeries series = new RunSeries(List.of(whole, cutShort));
    series.write(directory);
    JsonNode json = new ObjectMapper().readTree(directory.resolve(RunReport.SUMMARY).toFile());
    assertThat(series.success()).isFalse();
    assertThat(json.get("success").asBoolean()).isFalse();
    assertThat(json.get("runs").asInt()).isEqualTo(2);
    assertThat(json.get("runsSucceeded").asInt()).isEqualTo(1);
    assertThat(json.get("perRun").get(1).get("waypointsCaptured").asInt()).isEqualTo(5);
    double worst =
        whole.score().waypoints().stream()
            .mapToDouble(w -> w.missM().getAsDouble())
            .max()
            .getAsDouble();
    assertThat(json.get("worstMissM").asDouble()).isCloseTo(worst, within(0.001));
  }

  @Test
  void newSeries_noRuns_isRefused() {
    assertThatThrownBy(() -> new RunSeries(List.of())).hasMessageContaining("at least one run");
  }
}
