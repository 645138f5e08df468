package org.u2sa.fuzz;

import java.util.Map;
import org.u2sa.core.security.User;
import org.u2sa.core.security.UserFile;
import org.u2sa.interfaces.BadInputException;

/** Users' files: read, written, and read again to the same. */
public final class UsersTarget {
  private UsersTarget() {}

  /** Called by the fuzzer. */
  public static void fuzzerTestOneInput(byte[] data) {
    try (InputFile file = InputFile.of(data)) {
      Map<String, User> users = UserFile.read(file.path());
      UserFile.write(file.path(), users.values());
      Map<String, User> again = UserFile.read(file.path());
      Agreement.require(again.keySet().equals(users.keySet()), "read again", again, users);
      for (User user : users.values()) {
        Agreement.require(user.equals(again.get(user.name())), "user", again, user);
      }
    } catch (BadInputException e) {
      OneLine.require(e);
    }
  }
}
