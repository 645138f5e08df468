package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.frame.Geodetic;

class EnvironmentElementTest {
  private static final World PLAIN = World.at(new Geodetic(9.0, 54.0, 0.0));

  @TempDir private Path folder;

  private World read(String content) throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(file, "<environment>\n" + content + "\n</environment>");
    return EnvironmentElement.apply(XmlReader.read(file, "environment"), PLAIN, folder, 7L);
  }

  @Test
  void apply_everything_isInTheWorld() throws IOException {
    BufferedImage grey = new BufferedImage(2, 2, BufferedImage.TYPE_BYTE_GRAY);
    grey.getRaster().setSample(1, 0, 0, 255);
    ImageIO.write(grey, "png", folder.resolve("hills.png").toFile());

    World world =
        read(
            """
            <terrain>
              <heights>hills.png</heights> <width>40</width> <depth unit="km">0.04</depth>
              <lowest>-2</lowest> <highest>6</highest>
            </terrain>
            <surface>concrete</surface>
            <water><level>-1</level><current unit="kt">2</current><towards unit="deg">90</towards></water>
            <wind><speed>5</speed><from unit="deg">270</from><gusts>1.5</gusts><shear>true</shear></wind>
            """);

    assertThat(world.terrain().heightM(20.0, 20.0)).isCloseTo(6.0, within(1e-9));
    assertThat(world.terrain().heightM(-20.0, -20.0)).isCloseTo(-2.0, within(1e-9));
    assertThat(world.surface().grip(0.0, 0.0)).isCloseTo(0.75, within(1e-9));
    assertThat(world.water().orElseThrow().surfaceM()).isCloseTo(-1.0, within(1e-9));
    assertThat(world.water().orElseThrow().currentEastMps()).isCloseTo(1.0289, within(1e-3));
    assertThat(world.water().orElseThrow().currentNorthMps()).isCloseTo(0.0, within(1e-9));
    assertThat(world.wind().fromRad()).isCloseTo(Math.toRadians(270.0), within(1e-9));
    assertThat(world.wind().gustSigmaMps()).isCloseTo(1.5, within(1e-9));
    assertThat(world.wind().heightProfile()).isTrue();
    assertThat(world.wind().seed()).isEqualTo(7L);
  }

  @Test
  void apply_nothing_leavesTheWorldAsItIs() throws IOException {
    World world = read("");

    assertThat(world.terrain()).isSameAs(PLAIN.terrain());
    assertThat(world.water()).isEmpty();
  }

  @Test
  void apply_windWithoutGusts_hasThoseOfTheStandard() throws IOException {
    World world = read("<wind><speed>8</speed></wind>");

    assertThat(world.wind().gustSigmaMps()).isCloseTo(0.8, within(1e-9));
    assertThat(world.wind().heightProfile()).isFalse();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<wnd/> | wnd",
        "<wind/> | lacks <speed>",
        "<wind><speed>-3</speed></wind> | -3",
        "<wind><speed unit='kg'>3</speed></wind> | kg",
        "<wind><speed>3</speed><shear>yes</shear></wind> | expected true or false",
        "<water><current>90</current></water> | 90",
        "<surface>mud</surface> | expected lawn, concrete or field",
        "<surface><grip>9</grip><rollingResistance>0</rollingResistance></surface> | grip",
        "<terrain><heights>a.png</heights></terrain> | lacks <width>",
        "<terrain><heights>a.png</heights><width>1</width><depth>1</depth><lowest>0</lowest><highest>1</highest></terrain> | a.png"
      })
  void apply_invalid_namesWhatIsWrong(String content, String named) {
    assertThatThrownBy(() -> read(content))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(named);
  }
}
