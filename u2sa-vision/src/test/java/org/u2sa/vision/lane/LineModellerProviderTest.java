package org.u2sa.vision.lane;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;
import org.u2sa.world.WorldModeler;

/** The World Modeler with the modeller of this module. */
class LineModellerProviderTest {
  @ParameterizedTest
  @ValueSource(strings = {"LINES", "GRID, LINES"})
  void modellers_withLines_publishKnownObjects(String modellers, @TempDir Path folder)
      throws IOException {
    Path world = folder.resolve("world.xml");
    Files.writeString(
        world,
        "<world><reference>Local NED</reference>"
            + "<Circle><uid>mast</uid><x>5</x><y>-1</y><radius>0.3</radius></Circle></world>");
    try (ServiceKit kit = new ServiceKit()) {
      kit.with("MODELLERS", modellers).with("WORLD", world.toString()).start(WorldModeler::new);
      kit.send(
          Channels.STATE,
          new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).psi(0.0));
      kit.settle();
      kit.advance(0.5);

      assertThat(kit.latest(Channels.OBJECTS).orElseThrow().objects())
          .extracting(ObjectDescription::uid)
          .containsExactly("mast");
    }
  }
}
