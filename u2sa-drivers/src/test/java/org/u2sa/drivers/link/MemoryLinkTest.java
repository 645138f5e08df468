package org.u2sa.drivers.link;

/** A device in the same process. */
class MemoryLinkTest extends ByteLinkContract {
  @Override
  FarEnd device() {
    return FarEnds.memory();
  }
}
