package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

class FenceReaderTest {
  private static final Geodetic ORIGIN = new Geodetic(0.0, 0.0, 0.0);

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
    assertThat(fence.floorM.getAsDouble()).isEqualTo(30.48);
    assertThat(fence.ceilingM).hasValue(200.0);
    Fence smaller = fence.drawnInBy(5.0);
    assertThat(smaller.allows(Point.of(1.0, 1.0, 0.0))).isFalse();
    assertThat(smaller.allows(Point.of(50.0, 36.0, 0.0))).isFalse();
    assertThat(smaller.ceilingM).hasValue(195.0);
  }

  @Test
  void drawnInBy_moreThanThereIs_isRefused() {
    Fence fence = read(GOOD);

    assertThatThrownBy(() -> fence.drawnInBy(60.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("a margin of 60 m leaves no connected keep-in area");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<x>100</x><y>100</y> | <x>-100</x><y>50</y> | line 5, <keepIn>: encloses no area in one piece",
        "<ceiling>200         | <ceiling>20          | line 4, <ceiling>: 20.0 m is not above the floor of 30.48 m",
        "<ceiling>200         | <ceiling>1e308       | line 4, <ceiling>: 1.0E308 m: expected at most 1.0E9",
        "<radius>10           | <radius>1e300        | line 13, <radius>: 1.0E300 m: expected at most 1.0E9",
        "<x>100</x><y>100</y> | <x>1e300</x><y>1</y> | <x>: 1.0E300 m: expected at most 1.0E9",
        "<radius>10           | <radius>0            | line 13, <radius>: 0.0 m: expected more than 0 m",
        "<y>50</y>            | <z>50</z>            | line 12, <z>",
        "Local ENU            | Body                 | line 2, <reference>: \"Body\" is not one of Global, Local ENU",
        "Local ENU            | Global               | line 8, <y>: 100.0 is outside -90.0…90.0 deg of latitude",
        "<x>0</x><y>100</y>   | <x>0</x>             | lacks <y>",
        "<ceiling>200         | <ceiling>30.48       | line 4, <ceiling>: 30.48 m is not above the floor of 30.48 m",
        "<x>100</x><y>100</y> | <x>50</x><y>0</y>    | line 5, <keepIn>: encloses no area in one piece",
        "<radius>10</radius>  | ''                   | line 11, <keepOut>: has a <centre> but no <radius>",
        "<fence>              | <fence on=\"1\">      | line 1, <fence>: unknown attribute \"on\"",
        "<floor unit=\"ft\">    | <floor units=\"ft\">  | line 3, <floor>: unknown attribute \"units\"",
        "<ceiling>            | <ceiling of=\"1\">    | line 4, <ceiling>: unknown attribute \"of\"",
        "<keepIn>             | <keepIn name=\"a\">   | line 5, <keepIn>: unknown attribute \"name\"",
        "<corner><x>0</x><y>0 | <corner n=\"1\"><x>0</x><y>0 | line 6, <corner>: unknown attribute \"n\"",
        "<corner><x>0</x><y>0 | <corner><x n=\"1\">0</x><y>0 | line 6, <x>: unknown attribute \"n\"",
        "<keepOut>            | <keepOut name=\"a\">  | line 11, <keepOut>: unknown attribute \"name\"",
        "<radius>             | <radius r=\"1\">      | line 13, <radius>: unknown attribute \"r\"",
        "<radius>             | <height>1</height><radius> | line 13, <height>: unknown element in <keepOut>",
        "<keepIn>             | <keepIn><centre/>    | line 6, <corner>: unknown element in <keepIn>",
        "<y>50</y>            | <y>50</y><z>1</z>    | line 12, <z>: unknown element in <centre>",
        "<keepIn>             | <roof/><keepIn>      | line 5, <roof>: unknown element in <fence>",
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
  void read_keepInOfTwoCorners_saysHowManyAreExpected() {
    String text = "<fence><keepIn>%s</keepIn></fence>";
    String corners = "<corner><x>0</x><y>0</y></corner><corner><x>1</x><y>0</y></corner>";

    assertThatThrownBy(() -> read(String.format(text, corners)))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("<keepIn>: has 2 <corner>; expected 3 or more");
    String third = "<corner><x>0</x><y>1</y></corner>";
    assertThat(read(String.format(text, corners + third)).corners(ORIGIN)).hasSize(4);
  }

  @ParameterizedTest
  @CsvSource({"0, 0, 0, 0, 0, 0", "0, 0, 1, 1, 2, 2", "0, 0, 2, 0, 1, 0", "5, 5, 5, 5, 9, 9"})
  void read_keepInThatIsAPointOrALine_isRefusedWithTheReason(
      String x1, String y1, String x2, String y2, String x3, String y3) {
    String text =
        "<fence><reference>Local ENU</reference><keepIn><corner><x>%s</x><y>%s</y></corner>"
            + "<corner><x>%s</x><y>%s</y></corner><corner><x>%s</x><y>%s</y></corner></keepIn>"
            + "</fence>";

    assertThatThrownBy(() -> read(String.format(text, x1, y1, x2, y2, x3, y3)))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("<keepIn>: encloses no area in one piece (")
        .hasMessageEndingWith("; expected the corners in order, once around");
  }

  @Test
  void read_noReference_isOnTheEarthWithinLongitudeAndLatitude() {
    String text =
        "<fence><keepIn><corner><x>%s</x><y>47</y></corner><corner><x>9</x><y>47</y></corner>"
            + "<corner><x>9</x><y>48</y></corner></keepIn></fence>";

    assertThat(read(String.format(text, "8")).corners(ORIGIN).get(0).longitudeDeg())
        .isCloseTo(8.0, within(1e-9));
    assertThatThrownBy(() -> read(String.format(text, "181")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("<x>: 181.0 is outside -180.0…180.0 deg of longitude");
  }

  @Test
  void read_cornersInFeet_areThereInMetres() {
    Fence fence = read(GOOD.replace("<x>100</x>", "<x unit=\"ft\">1000</x>"));

    assertThat(fence.allows(Point.of(304.7, 50.0, 0.0))).isTrue();
    assertThat(fence.allows(Point.of(304.9, 50.0, 0.0))).isFalse();
  }

  /** Whatever the direction: corners of its polygon, and the middles of the sides between them. */
  @Test
  void read_circle_leavesNoneOfItOutAndIsHardlyWider() {
    Fence fence = read(GOOD);

    for (int i = 0; i < 256; i++) {
      double angle = 2.0 * Math.PI * i / 256;
      double east = Math.cos(angle);
      double north = Math.sin(angle);
      assertThat(fence.allows(Point.of(50.0 + 9.999 * east, 50.0 + 9.999 * north, 0.0)))
          .as("within, at %s rad", angle)
          .isFalse();
      assertThat(fence.allows(Point.of(50.0 + 10.02 * east, 50.0 + 10.02 * north, 0.0)))
          .as("without, at %s rad", angle)
          .isTrue();
    }
  }

  @Test
  void read_exampleOfTheCessna_isRead() {
    assertThat(FenceReader.read(Path.of("../config/cessna/fence.xml")).ceilingM).isPresent();
  }

  /** A circle to stay within has its corners on it, one to stay out of its edges. */
  @Test
  void read_circles_areWithinTheKeepInAndAroundTheKeepOut() {
    String circle = "<centre><x>0</x><y>0</y></centre><radius>100</radius>";
    String form = "<fence><reference>Local ENU</reference><%1$s>%2$s</%1$s></fence>";
    Fence in = read(String.format(form, "keepIn", circle));
    Fence out = read(String.format(form, "keepOut", circle));

    assertThat(in.allows(Point.of(99.8, 0.0, 0.0))).isTrue();
    assertThat(in.allows(Point.of(0.0, 100.01, 0.0))).isFalse();
    assertThat(out.allows(Point.of(99.99, 0.0, 0.0))).isFalse();
    assertThat(out.allows(Point.of(100.2, 0.0, 0.0))).isTrue();
    assertThat(out.clearanceM(Point.of(1000.0, 0.0, 0.0))).isCloseTo(900.0, within(0.2));
  }
}
