package org.u2sa.drivers.link;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.mqtt.AccountFolders;

/**
 * Loads the native library of jSerialComm from a folder that only this account can write.
 *
 * <p>jSerialComm unpacks it to a folder of fixed name in the system's temporary folder, open to
 * every account, and loads what it finds there: another account could run its own code in the
 * vehicle's program. It offers no option for another folder, but reads the path of the temporary
 * folder once, when its class is initialised.
 */
final class SerialLibrary {
  private static final String TEMPORARY = "java.io.tmpdir";
  private static final String CHOSEN = "jSerialComm.library.path"; // by the user

  private SerialLibrary() {}

  /**
   * Loads it; without effect from the second call on.
   *
   * @throws IOException if there is no such folder
   */
  static synchronized void load() throws IOException {
    if (!System.getProperty(CHOSEN, "").isEmpty()) {
      return;
    }
    String usual = System.getProperty(TEMPORARY);
    System.setProperty(TEMPORARY, folder().toString());
    try {
      SerialPort.getVersion(); // initialises the class
    } finally {
      System.setProperty(TEMPORARY, usual);
    }
  }

  /** The account's folder, or for an account that can keep no files a new temporary one. */
  private static Path folder() throws IOException {
    try {
      List<Path> folders = AccountFolders.ofProcess().all();
      Path lasting = folders.get(folders.size() - 1); // others may refuse to run programs
      AccountFolders.prepare(lasting);
      Path folder = lasting.resolve("serial");
      AccountFolders.prepare(folder);
      return folder.toAbsolutePath();
    } catch (IOException | BadInputException e) {
      return Files.createTempDirectory("u2sa-serial-"); // with access for its owner only
    }
  }
}
