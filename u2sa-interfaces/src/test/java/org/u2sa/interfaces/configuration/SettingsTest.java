package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Variables as one record: bound, checked, documented and live. */
@Timeout(120)
class SettingsTest {
  private enum End {
    HOLD,
    STOP
  }

  private record Variables(
      @Variable(unit = "m/s", min = 30, max = 60, ifAbsent = 40) @Description("Speed on legs.")
          double cruiseSpeed,
      @Variable(name = "STALL", unit = "m/s", min = 0, minExcluded = true)
          @Description("Stall speed.")
          double stallSpeed,
      @Variable(min = 1, max = 9, ifAbsent = 3) @Description("Passes at a waypoint.") int attempts,
      @Variable(ifAbsentText = "") @Description("File of the mission.") String mission,
      @Variable(
              oneOf = {"slow", "fast"},
              ifAbsentText = "slow")
          @Description("How.")
          String mode,
      @Variable(ifAbsentText = "true") @Description("Whether it loops.") boolean loop,
      @Variable(ifAbsentText = "STOP") @Description("What follows.") End atEnd) {
    Variables {
      if (stallSpeed >= cruiseSpeed) {
        throw new IllegalArgumentException("STALL must be below CRUISE SPEED");
      }
    }
  }

  private record Pair(
      @Variable(min = 0, max = 1000, ifAbsent = 0) @Description("One.") int one,
      @Variable(min = 0, max = 1000, ifAbsent = 0) @Description("The same.") int two) {
    Pair {
      if (one != two) {
        throw new IllegalArgumentException("ONE and TWO differ");
      }
    }
  }

  private record Unchecked(double plain) {}

  private record WrongDefault(
      @Variable(max = 1, ifAbsent = 2) @Description("Too much.") double share) {}

  private record WrongKind(@Variable(ifAbsent = 2) @Description("A text.") String text) {}

  private record WrongType(@Variable @Description("A date.") long micros) {}

  private record Undescribed(@Variable(ifAbsent = 2) double share) {}

  private record Described(
      @Variable(ifAbsent = 2) @Description("A share of something larger.") double share) {}

  @TempDir private Path directory;

  private Path file(String... variables) throws IOException {
    return Files.writeString(
        directory.resolve("control.xml"),
        "<configuration>\n" + String.join("\n", variables) + "\n</configuration>\n");
  }

  private static String variable(String name, String type, String value) {
    return "<variable name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
  }

  private static final String STALL = variable("STALL", "double", "25");

  @Test
  void get_variablesGivenAndAbsent_areTheFilesAndTheDefaults() throws IOException {
    XmlConfiguration configuration =
        XmlConfiguration.load(
            file(
                "<variable name=\"CRUISE SPEED\" type=\"double\" value=\"90\" unit=\"kt\"/>",
                STALL,
                variable("AT END", "string", "HOLD")));

    Variables tuning = configuration.settings(Variables.class).get();

    assertThat(tuning.cruiseSpeed()).isCloseTo(46.3, within(0.001));
    assertThat(tuning)
        .isEqualTo(new Variables(tuning.cruiseSpeed(), 25.0, 3, "", "slow", true, End.HOLD));
    configuration.refuseUndeclared();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "CRUISE SPEED | double | 61     | 61 m/s is outside 30…60 m/s",
        "CRUISE SPEED | string | fast   | type is string, expected double",
        "CRUISE SPEED | double | fast   | \"fast\" is not a number",
        "STALL        | double | 0      | 0 m/s is not above 0 m/s",
        "ATTEMPTS     | int    | 10     | 10 is outside 1…9",
        "MODE         | string | Slow   | \"Slow\" is not one of \"slow\", \"fast\"",
        "LOOP         | boolean| maybe  | \"maybe\" is not true or false",
        "AT END       | string | hold   | \"hold\" is not one of \"HOLD\", \"STOP\"",
      })
  void settings_wrongValue_isRefusedWithFileLineVariableAndExpectation(
      String name, String type, String value, String why) throws IOException {
    String[] lines =
        name.equals("STALL")
            ? new String[] {"", variable(name, type, value)}
            : new String[] {STALL, variable(name, type, value)};
    Path file = file(lines);

    assertThatThrownBy(() -> XmlConfiguration.load(file).settings(Variables.class))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContainingAll(file + ", line 3", "variable \"" + name + "\"", why);
  }

  @Test
  void settings_requiredVariableAbsent_isRefusedWithWhatItIs() throws IOException {
    Path file = file(variable("LOOP", "boolean", "false"));

    assertThatThrownBy(() -> XmlConfiguration.load(file).settings(Variables.class))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContainingAll(
            file.toString(), "\"STALL\": is required and missing", "in m/s", "Stall speed.");
  }

  @Test
  void refuseUndeclared_misspeltVariable_namesLineAndTheNearest() throws IOException {
    XmlConfiguration configuration =
        XmlConfiguration.load(file(STALL, variable("CRUISE SPED", "double", "40")));
    configuration.settings(Variables.class);

    assertThatThrownBy(configuration::refuseUndeclared)
        .hasMessageContainingAll("line 3", "\"CRUISE SPED\"", "CRUISE SPEED\"");
  }

  @Test
  void settings_valuesThatDoNotGoTogether_areRefusedWithLinesAndValues() throws IOException {
    Path file = file(variable("STALL", "double", "50"), variable("LOOP", "boolean", "true"));

    assertThatThrownBy(() -> XmlConfiguration.load(file).settings(Variables.class))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            file
                + ": STALL must be below CRUISE SPEED (variable \"CRUISE SPEED\" is 40 m/s; "
                + "line 2: variable \"STALL\" is 50 m/s)");
  }

  @Test
  void change_thatTheRecordRefuses_isNotWritten() throws IOException {
    Path file = file(STALL);
    XmlConfiguration configuration = XmlConfiguration.load(file);
    Settings<Variables> tuning = configuration.settings(Variables.class);

    assertThat(configuration.change("STALL", 45.0).orElseThrow())
        .contains(file.toString(), "STALL must be below CRUISE SPEED", "\"STALL\" is 45 m/s");
    assertThat(tuning.get().stallSpeed()).isEqualTo(25.0);
    assertThat(Files.readString(file)).contains(STALL);
  }

  @Test
  void get_afterChangesTogetherAndUndo_followsThem() throws IOException {
    XmlConfiguration configuration = XmlConfiguration.load(file(STALL));
    Settings<Variables> tuning = configuration.settings(Variables.class);
    Variables before = tuning.get();
    ChangeOrigin here = ChangeOrigin.here();

    configuration.change(
        Map.of("STALL", 45.0, "CRUISE SPEED", 55.0),
        OptionalLong.empty(),
        here,
        ConfigurationCheck.NONE);
    assertThat(tuning.get().stallSpeed()).isEqualTo(45.0);
    assertThat(tuning.get().cruiseSpeed()).isEqualTo(55.0);

    configuration.undo(here, ConfigurationCheck.NONE);
    assertThat(tuning.get()).isEqualTo(before);
  }

  @Test
  void get_changeThatIsWrittenButNotInEffect_isNotSeenYet() throws IOException {
    XmlConfiguration configuration = XmlConfiguration.load(file(STALL));
    Settings<Variables> tuning = configuration.settings(Variables.class);
    WrittenChange written =
        configuration.write(
            Map.of("STALL", 26.0),
            OptionalLong.empty(),
            ChangeOrigin.here(),
            ConfigurationCheck.NONE);

    assertThat(tuning.get().stallSpeed()).isEqualTo(25.0);
    written.takeEffect();
    assertThat(tuning.get().stallSpeed()).isEqualTo(26.0);
  }

  @Test
  void get_nothingChanged_isTheSameObject() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("here", Map.of("STALL", 25.0));
    Settings<Variables> tuning = configuration.settings(Variables.class);

    assertThat(tuning.get()).isSameAs(tuning.get());
  }

  @Test
  void get_fromTwoThreadsWhileItChanges_valuesAreOfOneMoment() throws Exception {
    XmlConfiguration configuration = XmlConfiguration.inMemory("here", Map.of());
    Settings<Pair> pair = configuration.settings(Pair.class);
    AtomicBoolean done = new AtomicBoolean();
    Callable<Integer> reader =
        () -> {
          int last = 0;
          while (!done.get()) {
            Pair now = pair.get(); // a mixture would be refused by the record
            assertThat(now.one()).isEqualTo(now.two()).isGreaterThanOrEqualTo(last);
            last = now.one();
          }
          return pair.get().one();
        };
    ExecutorService threads = Executors.newFixedThreadPool(2);
    try {
      List<Future<Integer>> readers = List.of(threads.submit(reader), threads.submit(reader));
      for (int i = 1; i <= 500; i++) {
        configuration.change(
            Map.of("ONE", i, "TWO", i),
            OptionalLong.empty(),
            ChangeOrigin.here(),
            ConfigurationCheck.NONE);
      }
      done.set(true);
      for (Future<Integer> each : readers) {
        assertThat(each.get()).isEqualTo(500);
      }
    } finally {
      done.set(true);
      threads.shutdown();
    }
  }

  @Test
  void settings_ofASuccessor_followItsOwnConfiguration() {
    XmlConfiguration old = XmlConfiguration.inMemory("here", Map.of("STALL", 25.0));
    old.settings(Variables.class);
    old.change("STALL", 27.0);

    assertThat(old.forSuccessor().settings(Variables.class).get().stallSpeed()).isEqualTo(27.0);
  }

  @Test
  void settings_recordThatIsDeclaredWrongly_saysWhichVariable() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("here", Map.of());

    assertThatThrownBy(() -> configuration.settings(Unchecked.class))
        .hasMessageContaining("expected a record whose components all have @Variable");
    assertThatThrownBy(() -> configuration.settings(WrongDefault.class))
        .hasMessageContainingAll("WrongDefault", "\"SHARE\"", "2 is not at most 1");
    assertThatThrownBy(() -> configuration.settings(WrongKind.class))
        .hasMessageContainingAll("WrongKind", "\"TEXT\": ifAbsent does not fit");
    assertThatThrownBy(() -> configuration.settings(WrongType.class))
        .hasMessageContainingAll("WrongType", "\"MICROS\": long is neither double");
  }

  @Test
  void settings_descriptionOfItsOwn_isTheVariables() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("here", Map.of());
    assertThatThrownBy(() -> configuration.settings(Undescribed.class))
        .hasMessageContainingAll("Undescribed", "expected a @Description");

    configuration.settings(Described.class);

    assertThat(configuration.declared())
        .extracting(VariableDeclaration::description)
        .containsExactly("A share of something larger.");
  }

  @Test
  void declared_ofARecord_areThoseDeclaredInCode() {
    List<VariableDeclaration<?>> constants =
        List.of(
            VariableDeclaration.integer("ONE")
                .range(Range.of(0, 1000))
                .ifAbsent(0)
                .describedAs("One."),
            VariableDeclaration.integer("TWO")
                .range(Range.of(0, 1000))
                .ifAbsent(0)
                .describedAs("The same."));
    XmlConfiguration configuration = XmlConfiguration.inMemory("here", Map.of());
    configuration.settings(Pair.class);

    assertThat(configuration.declared()).isEqualTo(constants);
  }
}
