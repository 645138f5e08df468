package org.u2sa.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.u2sa.world.ModelledWorld.local;
import static org.u2sa.world.ModelledWorld.seen;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;

/** What a world file names: published, matched, moved on, and refused. */
class KnownWorldTest {
  @TempDir private Path folder;
  private final ModelledWorld world = new ModelledWorld();

  @AfterEach
  void close() {
    world.close();
  }

  @Test
  void world_fileOfObjects_isPublishedNeverForgottenAndMatched() throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(
        file,
        "<world><reference>Local NED</reference>\n"
            + "<Circle><uid>barrel 1</uid><type>barrel</type><x>5</x><y>-1</y>"
            + "<radius>0.3</radius></Circle>\n"
            + "<MovingSphere><uid>cart</uid><x>0</x><y>50</y><radius>2</radius>"
            + "<xDot unit=\"km/h\">3.6</xDot><yDot>0</yDot></MovingSphere></world>");
    world.kit.with("MODELLERS", "OBJECTS").with("WORLD", file.toString()).start(WorldModeler::new);
    for (int i = 0; i < 5; i++) {
      world.tick(local(0.0, 0.0, 0.0), seen("a", 4.9, 1.1));
    }
    world.kit.advance(1.5);

    assertThat(world.objects())
        .extracting(ObjectDescription::uid)
        .containsExactly("barrel 1", "cart");
    assertThat(world.objects().get(0).x()).isEqualTo(5.0);
    assertThat(world.objects().get(1).x()).isCloseTo(2.0, within(0.11)); // 1 m/s since the start
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void world_modelNotFound_isWarnedOfAtTheStartAndWhenChanged(boolean atTheStart)
      throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("house.sdf"),
            "<sdf version='1.9'><world name='w'><include><uri>model://house</uri></include>"
                + "</world></sdf>");
    world.kit.with("MODELLERS", "OBJECTS");
    if (atTheStart) {
      world.kit.with("WORLD", file.toString()).start(WorldModeler::new);
    } else {
      world.kit.start(WorldModeler::new);
      world.change("WORLD", file.toString());
    }
    world.stand(10);

    assertThat(world.kit.log("WorldModeler"))
        .anyMatch(
            line ->
                line.contains("WARN")
                    && line.contains(
                        "not in the map, but possibly in the way: house: model model://house is"
                            + " not found (WORLD "
                            + file));
  }

  @Test
  void world_moversNotKnownBeforehand_onlyWhatStandsIsPublished() throws IOException {
    world.kit.with("MODELLERS", "OBJECTS").with("WORLD", mastAndCart().toString());
    world.kit.with("WORLD MOVERS", false).start(WorldModeler::new);
    world.tick(local(0.0, 0.0, 0.0), seen("a", 4.9, 1.1));
    world.kit.advance(0.5);
    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("mast");
  }

  @ParameterizedTest
  @ValueSource(strings = {"OBJECTS", "REACTIVE"})
  void worldMovers_changedWhileRunning_moverGoesAndComesBackWhereItIsByNow(String modeller)
      throws IOException {
    world.kit.with("MODELLERS", modeller).with("WORLD", mastAndCart().toString());
    world.kit.start(WorldModeler::new);
    world.stand(10);
    world.change("WORLD MOVERS", "false");
    world.stand(20);
    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("mast");

    world.change("WORLD MOVERS", "true");
    world.stand(10);
    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("mast", "cart");
    assertThat(world.objects().get(1).x()).isCloseTo(4.0, within(0.11)); // 1 m/s since the start
  }

  @Test
  void world_serviceSwappedOrModellersChanged_moverIsWhereItWouldHaveBeen() throws IOException {
    world.kit.with("MODELLERS", "OBJECTS").with("WORLD", mastAndCart().toString());
    WorldModeler modeler = world.kit.start(WorldModeler::new);
    world.stand(10);
    world.kit.swap(modeler, WorldModeler::new);
    world.stand(10);
    assertThat(world.objects().get(1).x()).isCloseTo(2.0, within(0.11));

    world.change("MODELLERS", "REACTIVE");
    world.stand(10);
    assertThat(world.objects().get(1).x()).isCloseTo(3.0, within(0.11));
    world.change("MODELLERS", "OBJECTS");
    world.stand(10);
    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("mast", "cart");
    assertThat(world.objects().get(1).x()).isCloseTo(4.0, within(0.11));
  }

  @ParameterizedTest
  @ValueSource(strings = {"OBJECTS", "REACTIVE", "GRID"})
  void world_whicheverModellersWork_isPublished(String modellers) throws IOException {
    world.kit.with("MODELLERS", modellers).with("WORLD", mastAndCart().toString());
    world.kit.start(WorldModeler::new);
    world.stand(10);
    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("mast", "cart");
    assertThat(world.objects().get(1).x()).isCloseTo(1.0, within(0.11)); // 1 m/s since the start
  }

  @Test
  void world_moreObjectsThanAreKept_allArePublished() throws IOException {
    world.kit.with("MODELLERS", "OBJECTS").with("WORLD", mastAndCart().toString());
    world.kit.with("MAX OBJECTS", 1).start(WorldModeler::new);
    for (int i = 0; i < 10; i++) {
      world.tick(local(0.0, 0.0, 0.0), seen("barrel", 3.0, -2.0), seen("crate", 3.0, 4.0));
    }
    assertThat(world.objects())
        .extracting(ObjectDescription::uid)
        .hasSize(3)
        .contains("mast", "cart");
  }

  @Test
  void world_somethingPassesAFixture_staysAnObjectOfItsOwn() throws IOException {
    world.kit.with("MODELLERS", "OBJECTS").with("WORLD", mastAndCart().toString());
    world.kit.start(WorldModeler::new);
    for (int i = 0; i <= 80; i++) {
      double x = 0.1 * i; // passes the mast at 5 m
      world.tick(local(0.0, 0.0, 0.0), seen("bird", x, 1.0));
      if (i >= 30) {
        assertThat(world.objects())
            .as("bird at %.1f m", x)
            .extracting(ObjectDescription::uid)
            .contains("mast", "bird");
      }
    }
  }

  @Test
  void world_neverSeenWhereItIsSaidToBe_isAsCertainAsBefore() throws IOException {
    world.kit.with("MODELLERS", "OBJECTS").with("WORLD", mastAndCart().toString());
    world.kit.with("FIELDS OF VIEW", "Camera: 120 deg, 8 m").start(WorldModeler::new);
    world.tick(local(0.0, 0.0, 0.0));
    double before = mast().confidence().orElseThrow();
    lookElsewhere();

    assertThat(mast().confidence().orElseThrow()).isEqualTo(before).isGreaterThan(0.9);
  }

  @Test
  void doubtFile_neverSeenWhereItIsSaidToBe_isDropped() throws IOException {
    world.kit.with("MODELLERS", "OBJECTS").with("WORLD", mastAndCart().toString());
    world.kit.with("FIELDS OF VIEW", "Camera: 120 deg, 8 m").with("DOUBT FILE", true);
    world.kit.start(WorldModeler::new);
    lookElsewhere();

    assertThat(world.objects()).extracting(ObjectDescription::uid).doesNotContain("mast");
  }

  @Test
  void doubtFile_moverLeftTheFieldOfView_isKept() throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(
        file,
        "<world><reference>Local NED</reference><Circle><uid>cart</uid><type>cart</type><x>7.5</x>"
            + "<y>0</y><radius>0.3</radius><xDot>20</xDot><yDot>0</yDot></Circle></world>");
    world.kit.with("MODELLERS", "OBJECTS").with("WORLD", file.toString());
    world.kit.with("FIELDS OF VIEW", "Camera: 120 deg, 8 m").with("DOUBT FILE", true);
    world.kit.start(WorldModeler::new);
    world.stand(5);
    lookElsewhere();

    assertThat(world.objects()).extracting(ObjectDescription::uid).contains("cart");
  }

  @Test
  void world_objectAroundTheVehicle_staysWhereItIsAtTheFirstState() throws IOException {
    world.kit.with("MODELLERS", "OBJECTS").with("WORLD", postAhead().toString());
    world.kit.start(WorldModeler::new);
    world.kit.advance(0.2);
    assertThat(world.objects()).isEmpty();

    world.tick(local(10.0, 0.0, Math.PI / 2.0)); // north 10 m, and it looks east
    requireAt(10.5, 3.0);
    world.tick(local(10.0, 6.0, 0.0));
    requireAt(10.5, 3.0);
    world.change("WORLD MOVERS", "false");
    world.tick(local(10.0, 7.0, 0.0));
    requireAt(10.5, 3.0);
  }

  @Test
  void world_objectAroundTheVehicleAndServiceSwapped_staysThere() throws IOException {
    world.kit.with("MODELLERS", "OBJECTS").with("WORLD", postAhead().toString());
    WorldModeler modeler = world.kit.start(WorldModeler::new);
    world.tick(local(10.0, 0.0, Math.PI / 2.0));
    world.tick(local(10.0, 6.0, 0.0));
    world.kit.swap(modeler, WorldModeler::new);
    world.tick(local(10.0, 7.0, 0.0));
    requireAt(10.5, 3.0);
  }

  private Path postAhead() throws IOException {
    Path file = folder.resolve("start.xml");
    return Files.writeString(
        file,
        "<world><reference>BODY</reference><Circle><uid>post</uid><x>3</x><y>0.5</y>"
            + "<radius>0.1</radius></Circle></world>");
  }

  private void requireAt(double north, double east) {
    assertThat(world.objects()).extracting(ObjectDescription::uid).containsExactly("post");
    assertThat(world.objects().get(0).center().distanceTo(Point.of(north, east, 0.0)))
        .isLessThan(1e-6);
  }

  private ObjectDescription mast() {
    return world.objects().stream()
        .filter(object -> object.uid().equals("mast"))
        .findFirst()
        .orElseThrow();
  }

  private void lookElsewhere() {
    for (int i = 0; i < 30; i++) {
      world.tick(local(0.0, 0.0, 0.0), seen("barrel", 3.0, -2.0));
    }
  }

  @Test
  void world_wrongFile_refusesToStartNamingTheLine() throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(file, "<world>\n<Circel><x>1</x></Circel></world>");
    world.kit.with("WORLD", file.toString());
    assertThatThrownBy(() -> world.kit.start(WorldModeler::new))
        .hasMessageContaining("world.xml, line 2, <Circel>")
        .hasMessageContaining("Circle");
  }

  private Path mastAndCart() throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(
        file,
        "<world><reference>Local NED</reference>"
            + "<Circle><uid>mast</uid><x>5</x><y>-1</y><radius>0.3</radius></Circle>"
            + "<MovingSphere><uid>cart</uid><x>0</x><y>50</y><radius>2</radius>"
            + "<xDot>1</xDot><yDot>0</yDot></MovingSphere></world>");
    return file;
  }
}
