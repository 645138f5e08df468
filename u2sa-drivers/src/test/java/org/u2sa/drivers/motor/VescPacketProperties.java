package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;

class VescPacketProperties {
  @Property(tries = 300)
  void accept_packetsAmongNoise_areFoundOnceNoiseHasPassed(
      @ForAll @Size(max = 40) byte[] noise, @ForAll @Size(min = 1, max = 200) byte[] payload) {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    line.writeBytes(noise);
    for (int i = 0; i < 300; i++) { // the longest packet that noise can pretend is 260 bytes
      line.writeBytes(VescPacket.of(payload));
    }
    List<byte[]> found = new ArrayList<>();
    new VescPacket(found::add, why -> {}).accept(line.toByteArray(), line.size());
    assertThat(found).isNotEmpty();
    assertThat(found.get(found.size() - 1)).isEqualTo(payload);
  }

  @Property(tries = 300)
  void accept_anyBytes_neverThrows(@ForAll byte[] noise) {
    VescPacket parser = new VescPacket(payload -> {}, why -> {});
    assertThatCode(
            () -> {
              for (byte each : noise) {
                parser.accept(new byte[] {each}, 1);
              }
            })
        .doesNotThrowAnyException();
  }
}
