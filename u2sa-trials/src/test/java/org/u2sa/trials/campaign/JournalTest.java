package org.u2sa.trials.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;

class JournalTest {
  private static final List<Experiment> RUNS =
      Experiment.all(List.of("demo", "ugv"), 1, 5, List.of());

  private static final SortedMap<String, String> INPUTS =
      new TreeMap<>(Map.of("my rover/vehicle.xml", "a1", "missions/m.xml", "b2"));

  @TempDir private Path directory;
  private Path file;

  @BeforeEach
  void place() {
    file = directory.resolve("runs.jsonl");
  }

  private List<Outcome> write(Outcome... outcomes) {
    List<Outcome> before = new ArrayList<>();
    try (Journal journal = Journal.open(file, "ugv", INPUTS, RUNS, before)) {
      for (Outcome outcome : outcomes) {
        journal.add(outcome);
      }
    }
    return before;
  }

  private static Outcome outcome(int number, int exit) {
    return new Outcome(RUNS.get(number - 1), exit, "{\n\"a\" : 1\n}", "said \"so\"\nand so");
  }

  @Test
  void open_journalOfTheSameCampaign_givesWhatWasDoneButNotWhatWasLost() {
    write(outcome(4, 0), outcome(2, RunAnswer.LOST), outcome(1, 1));

    assertThat(write(outcome(3, 0))).containsExactly(outcome(4, 0), outcome(1, 1));
    assertThat(write()).containsExactly(outcome(4, 0), outcome(1, 1), outcome(3, 0));
  }

  @Test
  void open_lineCutOff_isMadeAgain() throws IOException {
    write(outcome(1, 0), outcome(2, 0));
    String text = Files.readString(file);
    for (int cut = 1; cut < text.length() - text.indexOf("\n", text.indexOf("\"run\"")); cut++) {
      Files.writeString(file, text.substring(0, text.length() - cut));

      assertThat(write()).as("%d characters less", cut).containsExactly(outcome(1, 0));
      assertThat(write(outcome(2, 0))).containsExactly(outcome(1, 0));
      assertThat(write()).containsExactly(outcome(1, 0), outcome(2, 0));
    }
  }

  @Test
  void open_journalOfAnotherCampaign_isRefusedAndKept() throws IOException {
    write(outcome(1, 0));
    String text = Files.readString(file);

    assertThatThrownBy(() -> Journal.open(file, "cessna", INPUTS, RUNS, new ArrayList<>()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("runs.jsonl")
        .hasMessageContaining("\"ugv\"")
        .hasMessageContaining("--out");
    assertThat(file).hasContent(text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"my rover/vehicle.xml", "new.xml"})
  void open_inputsChanged_namesTheFileAndIsKept(String changed) throws IOException {
    write(outcome(1, 0));
    String text = Files.readString(file);
    SortedMap<String, String> inputs = new TreeMap<>(INPUTS);
    inputs.put(changed, "c3");

    assertThatThrownBy(() -> Journal.open(file, "ugv", inputs, RUNS, new ArrayList<>()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("another content of " + changed)
        .hasMessageContaining("--out");
    assertThat(file).hasContent(text);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{\"exit\":0}",
        "{\"run\":9,\"exit\":0}",
        "{\"run\":1,\"exit\":\"\"}",
        "{\"run\":0,\"exit\":0}",
        "\u0000\u0000",
        "{\"run\":1,"
      })
  void open_damagedLine_namesFileLineAndExpectation(String damaged) throws IOException {
    write(outcome(1, 0));
    Files.writeString(file, Files.readString(file) + damaged + "\n");
    String before = Files.readString(file);

    assertThatThrownBy(this::write)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("runs.jsonl, line 3")
        .hasMessageContaining("expected");
    assertThat(file).hasContent(before);
  }
}
