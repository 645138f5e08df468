package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.sim.atmosphere.WindProfile;

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
    assertThat(world.water().orElseThrow().currentAt(Point.ORIGIN).x())
        .isCloseTo(1.0289, within(1e-3));
    assertThat(world.water().orElseThrow().currentAt(Point.ORIGIN).y())
        .isCloseTo(0.0, within(1e-9));
    assertThat(world.wind().fromRad()).isCloseTo(Math.toRadians(270.0), within(1e-9));
    assertThat(world.wind().gustSigmaMps()).isCloseTo(1.5, within(1e-9));
    assertThat(world.wind().profile()).isEqualTo(WindProfile.military());
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
    assertThat(world.wind().profile()).isEqualTo(WindProfile.uniform());
  }

  @Test
  void apply_currentsWavesShearAndLight_areInTheWorld() throws IOException {
    World world =
        read(
            """
            <water>
              <level>-1</level>
              <currents><columns>2</columns><width>20</width><depth>20</depth>
                <east unit="kt">0 2 0 2</east><north>0 0 1 1</north></currents>
              <profile>0 1; 10 0</profile>
              <waves><height>0.5</height><period>4</period><towards unit="deg">90</towards></waves>
            </water>
            <wind><speed>6</speed><exponent>0.1</exponent><reference>10</reference></wind>
            <light><azimuth unit="deg">90</azimuth><elevation unit="deg">45</elevation></light>
            """);

    Water water = world.water().orElseThrow();
    assertThat(water.currentAt(Point.of(10.0, 10.0, -1.0)).x()).isCloseTo(1.0289, within(1e-3));
    assertThat(water.currentAt(Point.of(0.0, -10.0, -6.0)).y()).isCloseTo(0.5, within(1e-9));
    assertThat(water.waves()).isPresent();
    assertThat(world.wind().profile().share(20.0)).isCloseTo(Math.pow(2.0, 0.1), within(1e-9));
    assertThat(world.light().orElseThrow().elevationRad()).isCloseTo(Math.PI / 4.0, within(1e-9));
  }

  @Test
  void lit_behindAnObstacle_isDarker() throws IOException {
    World world =
        read("<light><azimuth unit='deg'>90</azimuth><elevation unit='deg'>45</elevation></light>")
            .with(
                List.of(
                    new Box()
                        .length(1.0)
                        .width(10.0)
                        .height(8.0)
                        .x(0.0)
                        .y(0.0)
                        .z(4.0)
                        .referenceFrame(ReferenceFrame.LOCAL_ENU)));
    Sunlight sun = world.light().orElseThrow();
    Ray shaded = new Ray(-2.0, 0.0, 3.0, 0.0, 0.0, -1.0);
    Ray bright = new Ray(5.0, 0.0, 3.0, 0.0, 0.0, -1.0);

    assertThat(sun.lit(0.5, bright, world.cast(bright, 9.0), world, 50.0))
        .isCloseTo(0.5, within(1e-9));
    assertThat(sun.lit(0.5, shaded, world.cast(shaded, 9.0), world, 50.0))
        .isCloseTo(0.15, within(1e-9));
    assertThat(
            sun.lit(
                0.9,
                Ray.of(Point.ORIGIN, Math.PI / 2.0, Math.PI / 4.0),
                Optional.empty(),
                world,
                9.0))
        .isEqualTo(1.0);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<wnd/> | wnd",
        "<wind/> | lacks <speed>",
        "<wind><speed>-3</speed></wind> | -3",
        "<wind><speed unit='kg'>3</speed></wind> | kg",
        "<water><waves><height>9</height><period>3</period></waves></water> | expected at most 2.01 m",
        "<water><waves><height>1</height></waves></water> | lacks <period>",
        "<water><waves><spectrum>tsunami</spectrum><height>1</height><period>9</period></waves></water> | expected one of regular, pierson-moskowitz, jonswap",
        "<water><profile>0 1 5</profile></water> | expected pairs",
        "<water><current>1</current><currents/></water> | expected only one of them",
        "<water><currents><columns>2</columns><width>9</width><depth>9</depth><east>1 2</east><north>1</north></currents></water> | expected equal numbers",
        "<wind><speed>3</speed><exponent>0.1</exponent><roughness>0.1</roughness></wind> | expected only one",
        "<light><azimuth>1</azimuth><elevation>9</elevation></light> | expected 0.02",
        "<terrain><heights>a.tif</heights><width>10</width><depth>10</depth></terrain> | a.tif",
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

  @Test
  void apply_heightsAreALinkOutOfTheFolder_isRefused(@TempDir Path elsewhere) throws IOException {
    Path secret = Files.writeString(elsewhere.resolve("hills.png"), "not for worlds");
    Files.createSymbolicLink(folder.resolve("hills.png"), secret);

    assertThatThrownBy(
            () ->
                read(
                    "<terrain><heights>hills.png</heights><width>1</width><depth>1</depth>"
                        + "<lowest>0</lowest><highest>1</highest></terrain>"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("\"hills.png\" is a link that leads out of " + folder);
  }
}
