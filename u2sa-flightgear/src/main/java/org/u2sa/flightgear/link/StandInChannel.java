package org.u2sa.flightgear.link;

import java.io.Closeable;
import java.io.IOException;
import org.u2sa.flightgear.protocol.InLine;
import org.u2sa.flightgear.protocol.OutLine;

/**
 * One of the stand-in's input and output channels, worked on in each of its frames, as FlightGear
 * does.
 */
interface StandInChannel extends Closeable {
  /**
   * Does what is due.
   *
   * @param told what the stand-in was told last
   * @param line what it says in this frame
   * @return what it has been told now
   * @throws IOException if the channel is lost for good
   */
  InLine work(InLine told, OutLine line) throws IOException;
}
