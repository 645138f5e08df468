import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import org.codehaus.mojo.animal_sniffer.Clazz;
import org.codehaus.mojo.animal_sniffer.SignatureChecker;

/** Which classes and methods a phone has: animal-sniffer's signatures, and the few that every phone has without promising them. */
final class PhoneApi {
  /** Netty and H2 look for it; of Android's "unsupported" list, which an application may use. */
  private static final Set<String> UNPROMISED = Set.of("sun/misc/Unsafe");

  private final Map<String, Clazz> classes;

  PhoneApi(Path signatures) throws IOException {
    try (InputStream in = Files.newInputStream(signatures)) {
      classes = SignatureChecker.loadClasses(in);
    }
  }

  /** Whether a phone has the class. Names have slashes. */
  boolean has(String name) {
    return classes.containsKey(name) || UNPROMISED.contains(name);
  }

  /** Whether the class, or one that it is made of, has the method or field; {@code signature}: name and descriptor. */
  boolean has(String owner, String signature) {
    if (UNPROMISED.contains(owner)) {
      return true;
    }
    Clazz known = classes.get(owner);
    return known != null
        && (known.getSignatures().contains(signature)
            || known.getSuperClass() != null && has(known.getSuperClass(), signature)
            || Arrays.stream(known.getSuperInterfaces()).anyMatch(parent -> has(parent, signature)));
  }
}
