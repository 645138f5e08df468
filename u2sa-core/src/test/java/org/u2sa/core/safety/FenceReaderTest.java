package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;

class FenceReaderTest {
  private static final String GOOD =
      """
      <fence>
        <reference>Local ENU</reference>
        <floor unit="ft">100</floor>
        <ceiling>200</ceiling>
        <keepIn>
          <corner><x>0</x><y>0</y></corner>
          <corner><x>100</x><y>0</y></corner>
          <corner><x>100</x><y>100</y></corner>
          <corner><x>0</x><y>100</y></corner>
        </keepIn>
        <keepOut>
          <centre><x>50</x><y>50</y></centre>
          <radius>10</radius>
        </keepOut>
      </fence>
      """;

  @TempDir private Path directory;

  private Fence read(String text) {
    try {
      return FenceReader.read(Files.writeString(directory.resolve("fence.xml"), text));
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  @Test
  void read_good_allowsInsideOnly() {
    Fence fence = read(GOOD);

    assertThat(fence.allows(Point.of(1.0, 1.0, 0.0))).isTrue();
    assertThat(fence.allows(Point.of(101.0, 1.0, 0.0))).isFalse();
    assertThat(fence.allows(Point.of(50.0, 41.0, 0.0))).isFalse();
    assertThat(fence.allows(Point.of(50.0, 39.9, 0.0))).isTrue();
    assertThat(fence.floorM().getAsDouble()).isEqualTo(30.48);
    assertThat(fence.ceilingM()).hasValue(200.0);
    Fence smaller = fence.drawnInBy(5.0);
    assertThat(smaller.allows(Point.of(1.0, 1.0, 0.0))).isFalse();
    assertThat(smaller.allows(Point.of(50.0, 36.0, 0.0))).isFalse();
    assertThat(smaller.ceilingM()).hasValue(195.0);
  }

  @Test
  void drawnInBy_moreThanThereIs_isRefused() {
    Fence fence = read(GOOD);

    assertThatThrownBy(() -> fence.drawnInBy(60.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("a margin of 60 m leaves no keep-in area in one piece");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<x>100</x><y>100</y> | <x>-100</x><y>50</y> | line 5, <keepIn>: encloses no area in one piece",
        "<ceiling>200         | <ceiling>20          | line 4, <ceiling>: 20.0 m is not above the floor of 30.48 m",
        "<radius>10           | <radius>0            | line 13, <radius>: 0.0 m: expected more than 0 m",
        "<y>50</y>            | <z>50</z>            | line 12, <z>",
        "Local ENU            | Body                 | line 2, <reference>: \"Body\" is not one of Global, Local ENU",
        "Local ENU            | Global               | line 8, <y>: 100.0 is outside -90.0…90.0 deg of latitude",
        "<x>0</x><y>100</y>   | <x>0</x>             | lacks <y>",
      })
  void read_wrong_namesLineAndWhatWasExpected(String good, String bad, String message) {
    assertThat(GOOD).contains(good);
    String text = GOOD.replace(good, bad);

    assertThatThrownBy(() -> read(text))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("fence.xml")
        .hasMessageContaining(message);
  }

  @Test
  void read_exampleOfTheCessna_isRead() {
    assertThat(FenceReader.read(Path.of("../config/cessna/fence.xml")).ceilingM()).isPresent();
  }
}
