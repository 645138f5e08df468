package org.u2sa.vision.marine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.marine.Bin;
import org.u2sa.messages.marine.Button;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.marine.PathMarker;
import org.u2sa.messages.marine.Pole;
import org.u2sa.sim.camera.Light;
import org.u2sa.sim.camera.WaterLook;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.vision.lens.LensCalibration;

/**
 * Detection on rendered pictures against truth. {@code -Du2sa.marine.seed=N} and {@code
 * -Du2sa.marine.pictures=N} score other pictures.
 */
class MarineSightTest {
  private static final long SEED = Long.getLong("u2sa.marine.seed", 2_000L);
  private static final int PICTURES = Integer.getInteger("u2sa.marine.pictures", 8);

  private static VehicleTruth truth(double up, double pitch) {
    return new VehicleTruth(
        1.0,
        Point.of(0.0, 0.0, up),
        new Attitude(0.0, pitch, Math.PI / 2.0),
        Point.ORIGIN,
        Point.ORIGIN,
        Point.ORIGIN);
  }

  private static List<SeenThing> seen(
      List<ObjectDescription> objects,
      WaterLook look,
      VehicleTruth truth,
      boolean underWater,
      MarineKind... kinds) {
    MarineVariables variables = RenderedBuoys.variables(underWater, 0.25);
    Rotation turn = truth.attitude().theta() < -1.0 ? Rotation.nedFromFrd(0, -1.57, 0) : null;
    MarineSight sight =
        turn == null
            ? RenderedBuoys.sight(variables)
            : new MarineSight(
                variables, new org.u2sa.vision.ground.CameraMount(Point.ORIGIN, turn, 0.0));
    return sight.look(
        RenderedBuoys.picture(objects, look, Light.clear(), truth, 5L),
        LensCalibration.pinhole(
            RenderedBuoys.WIDTH, RenderedBuoys.HEIGHT, RenderedBuoys.lens().intrinsics()),
        Rotation.nedFromFrd(0.0, 0.0, 0.0),
        EnumSet.copyOf(List.of(kinds)));
  }

  @Test
  void look_colouredBuoysOnTheSea_areFoundWithHonestDistances() {
    RenderedBuoys score =
        new RenderedBuoys(false, Colour.RED, Colour.GREEN, Colour.YELLOW, Colour.BLUE);
    for (int i = 0; i < PICTURES; i++) {
      score.score(SEED + i);
    }

    assertThat(score.found).as(score.toString()).isGreaterThan((int) (0.9 * score.shown));
    assertThat(score.falseAlarms).as(score.toString()).isLessThanOrEqualTo(1 + PICTURES / 4);
    assertThat(score.wrongColours).as(score.toString()).isLessThanOrEqualTo(PICTURES / 8);
    assertThat(score.rangesWithin3Sigma)
        .as(score.toString())
        .isGreaterThan((int) (0.95 * score.found));
    assertThat(score.bearingsWithin3Sigma)
        .as(score.toString())
        .isGreaterThan((int) (0.95 * score.found));
  }

  @Test
  void look_buoysUnderWater_areFoundWithTheirColours() {
    RenderedBuoys score =
        new RenderedBuoys(true, Colour.RED, Colour.GREEN, Colour.YELLOW, Colour.ORANGE);
    for (int i = 0; i < PICTURES; i++) {
      score.score(SEED + i);
    }

    assertThat(score.found).as(score.toString()).isGreaterThan((int) (0.9 * score.shown));
    assertThat(score.falseAlarms).as(score.toString()).isLessThanOrEqualTo(1 + PICTURES / 4);
    assertThat(score.wrongColours).as(score.toString()).isLessThanOrEqualTo(1 + PICTURES / 8);
    assertThat(score.rangesWithin3Sigma)
        .as(score.toString())
        .isGreaterThan((int) (0.95 * score.found));
  }

  @Test
  void look_hoopAndButtonAboveTheSea_areTheSoughtKinds() {
    List<ObjectDescription> objects =
        List.of(
            RenderedBuoys.at(
                new Hoop().radius(0.4).thickness(0.05).colour(Colour.PURPLE), 6.0, 2.0, 1.6),
            RenderedBuoys.at(
                new Button().length(0.1).width(0.4).height(0.4).psi(0.0).colour(Colour.RED),
                6.0,
                -2.0,
                1.2));

    List<SeenThing> seen =
        seen(
            objects,
            WaterLook.open(3.0),
            truth(0.9, 0.0),
            false,
            MarineKind.HOOP,
            MarineKind.BUTTON);

    assertThat(seen).extracting(SeenThing::kind).contains(MarineKind.HOOP, MarineKind.BUTTON);
    for (SeenThing each : seen) {
      assertThat(each.rangeM()).as("%s", each).isEqualTo(6.4, within(3.0 * each.rangeSigmaM()));
    }
  }

  @Test
  void look_polesAndHoopUnderWater_areTheSoughtKindsWithTheirColours() {
    List<ObjectDescription> objects =
        List.of(
            RenderedBuoys.at(
                new Hoop().radius(0.4).thickness(0.05).colour(Colour.YELLOW), 4.0, 1.0, -2.0),
            RenderedBuoys.at(
                new Pole().radius(0.05).height(1.5).colour(Colour.ORANGE), 4.0, -0.5, -2.0),
            RenderedBuoys.at(
                new Pole().radius(0.05).height(1.5).colour(Colour.GREEN), 4.0, -1.8, -2.0));

    List<SeenThing> seen =
        seen(objects, WaterLook.pool(), truth(-2.0, 0.0), true, MarineKind.POLE, MarineKind.HOOP);

    assertThat(seen)
        .extracting(thing -> thing.kind() + " " + thing.colour().map(Enum::name).orElse("?"))
        .containsExactlyInAnyOrder("HOOP YELLOW", "POLE ORANGE", "POLE GREEN");
  }

  @Test
  void look_markerAndBinOnThePoolsFloor_areLocated() {
    List<ObjectDescription> objects =
        List.of(
            RenderedBuoys.at(
                new PathMarker().length(1.2).width(0.15).psi(0.6).colour(Colour.ORANGE),
                0.3,
                0.5,
                -4.98),
            RenderedBuoys.at(
                new Bin().length(0.6).width(0.4).height(0.1).psi(0.3).colour(Colour.BLACK),
                0.3,
                -0.9,
                -4.95));

    List<SeenThing> seen =
        seen(
            objects,
            WaterLook.pool(),
            truth(-2.0, -1.57),
            true,
            MarineKind.BIN,
            MarineKind.PATH_MARKER);

    assertThat(seen)
        .extracting(thing -> thing.kind() + " " + thing.colour().map(Enum::name).orElse("?"))
        .containsExactlyInAnyOrder("PATH_MARKER ORANGE", "BIN BLACK");
    for (SeenThing each : seen) {
      assertThat(each.rangeM()).as("%s", each).isEqualTo(3.05, within(0.45));
    }
  }
}
