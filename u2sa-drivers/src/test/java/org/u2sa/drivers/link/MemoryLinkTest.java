package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;

/** A device in the same process. */
class MemoryLinkTest extends ByteLinkContract {
  @Override
  Device device() {
    MemoryLink memory = new MemoryLink();
    StringBuilder told = new StringBuilder();
    return new Device() {
      @Override
      public ByteLink open() {
        return memory.with(bytes -> told.append(new String(bytes, US_ASCII)));
      }

      @Override
      public void says(String text) {
        memory.fromDevice(text.getBytes(US_ASCII));
      }

      @Override
      public String wasTold() {
        return told.toString();
      }

      @Override
      public void unplug() {
        memory.unplug();
      }

      @Override
      public void plug() {
        memory.plug();
      }

      @Override
      public void end() {
        memory.close();
      }
    };
  }
}
