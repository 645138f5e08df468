package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class ConfigurationReferenceTest {
  private static class Service {
    static final VariableDeclaration<String> LEVEL =
        VariableDeclaration.text("LOG LEVEL")
            .oneOf("debug", "info")
            .ifAbsent("info")
            .describedAs("Lowest level that is written.");
  }

  private static class Control extends Service {
    private static final VariableDeclaration<Double> GAIN =
        VariableDeclaration.number("GAIN", "%/rad")
            .range(Range.of(0.0, 500.0))
            .ifAbsent(120.0)
            .describedAs("Speed | turn.");
    static final VariableDeclaration<Double> WEIGHT =
        VariableDeclaration.number("WEIGHT", "kg")
            .range(Range.positive())
            .describedAs("With\n fuel.");
    static final VariableDeclaration<Boolean> LOUD =
        VariableDeclaration.flag("LOUD").ifAbsent(false).describedAs("Beeps.");
    static final int OTHER = 1;
  }

  private static final class Quiet extends Service {}

  private static final class Undescribed {
    static final VariableDeclaration<Boolean> A = VariableDeclaration.flag("A");
  }

  @Test
  void markdownFor_services_hasATableForEachAndTheirAncestor() {
    assertThat(ConfigurationReference.markdownFor(Control.class, Quiet.class))
        .isEqualTo(
            "## Service\n\n"
                + "| Variable | Type | Unit | Range | Default | Meaning |\n"
                + "|---|---|---|---|---|---|\n"
                + "| `LOG LEVEL` | string | | \"debug\", \"info\" | \"info\""
                + " | Lowest level that is written. |\n"
                + "\n## Control\n\n"
                + "| Variable | Type | Unit | Range | Default | Meaning |\n"
                + "|---|---|---|---|---|---|\n"
                + "| `GAIN` | double | %/rad | 0…500 | 120 | Speed \\| turn. |\n"
                + "| `WEIGHT` | double | kg | above 0 | required | With fuel. |\n"
                + "| `LOUD` | boolean | | | false | Beeps. |\n"
                + "\nAlso those of [Service](#service).\n"
                + "\n## Quiet\n\nNo variables of its own.\n"
                + "\nAlso those of [Service](#service).\n");
    assertThat(Control.GAIN.ifAbsent()).contains(120.0);
  }

  @Test
  void markdownFor_noDescription_isRefused() {
    assertThatThrownBy(() -> ConfigurationReference.markdownFor(Undescribed.class))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageEndingWith("variable \"A\" (boolean): no description for the reference");
  }
}
