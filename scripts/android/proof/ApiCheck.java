import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Names what the application's classes, after D8, call that a phone lacks: a line for each class that calls and each missing thing, sorted, with
 * the word "asked" where the class, or the one around it, asks for the phone's API level. Run as {@code ApiCheck SIGNATURES CLASSES.jar}.
 */
final class ApiCheck {
  private final PhoneApi phone;
  private final Map<String, Set<String>> own = new HashMap<>(); // class → names and descriptors of its methods and fields
  private final Map<String, String[]> parents = new HashMap<>();
  private final Map<String, Set<String>> missing = new TreeMap<>(); // class that calls → what is not there
  private final Set<String> asking = new HashSet<>(); // outermost classes that ask for the API level

  private ApiCheck(PhoneApi phone) {
    this.phone = phone;
  }

  public static void main(String[] args) throws IOException {
    ApiCheck check = new ApiCheck(new PhoneApi(Path.of(args[0])));
    Path jar = Path.of(args[1]);
    check.each(jar, check::remember);
    check.each(jar, check::look);
    check.missing.forEach((caller, things) -> things.forEach(thing -> System.out.println(check.line(caller, thing))));
  }

  private String line(String caller, String thing) {
    return caller.replace('/', '.') + " " + thing + (asking.contains(outermost(caller)) ? " asked" : "");
  }

  private static String outermost(String name) {
    int end = name.indexOf('$');
    return end < 0 ? name : name.substring(0, end);
  }

  private interface Reading {
    void read(ClassReader reader);
  }

  private void each(Path jar, Reading reading) throws IOException {
    try (ZipFile zip = new ZipFile(jar.toFile())) {
      for (ZipEntry entry : Collections.list(zip.entries())) {
        if (entry.getName().endsWith(".class")) {
          try (InputStream in = zip.getInputStream(entry)) {
            reading.read(new ClassReader(in.readAllBytes()));
          }
        }
      }
    }
  }

  private void remember(ClassReader reader) {
    Set<String> members = new TreeSet<>();
    String[] interfaces = reader.getInterfaces();
    String[] above = new String[interfaces.length + 1];
    above[0] = reader.getSuperName();
    System.arraycopy(interfaces, 0, above, 1, interfaces.length);
    own.put(reader.getClassName(), members);
    parents.put(reader.getClassName(), above);
    reader.accept(
        new ClassVisitor(Opcodes.ASM9) {
          @Override
          public MethodVisitor visitMethod(int access, String name, String descriptor, String signature, String[] exceptions) {
            members.add(name + descriptor);
            return null;
          }

          @Override
          public FieldVisitor visitField(int access, String name, String descriptor, String signature, Object value) {
            members.add(name + "#" + descriptor);
            return null;
          }
        },
        ClassReader.SKIP_CODE | ClassReader.SKIP_DEBUG);
  }

  private void look(ClassReader reader) {
    String caller = reader.getClassName();
    for (String parent : parents.get(caller)) {
      type(caller, parent);
    }
    reader.accept(
        new ClassVisitor(Opcodes.ASM9) {
          @Override
          public MethodVisitor visitMethod(int access, String name, String descriptor, String signature, String[] exceptions) {
            return new MethodVisitor(Opcodes.ASM9) {
              @Override
              public void visitMethodInsn(int opcode, String owner, String method, String type, boolean isInterface) {
                member(caller, owner, method + type);
              }

              @Override
              public void visitFieldInsn(int opcode, String owner, String field, String type) {
                if (owner.equals("android/os/Build$VERSION") && field.equals("SDK_INT")) {
                  asking.add(outermost(caller));
                }
                member(caller, owner, field + "#" + type);
              }

              @Override
              public void visitTypeInsn(int opcode, String type) {
                type(caller, type);
              }
            };
          }
        },
        ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES);
  }

  private void type(String caller, String type) {
    if (type != null && !type.startsWith("[") && !own.containsKey(type) && !phone.has(type)) {
      note(caller, type);
    }
  }

  private void member(String caller, String owner, String signature) {
    if (owner.startsWith("[")) {
      return;
    }
    type(caller, owner);
    if ((own.containsKey(owner) || phone.has(owner)) && !found(owner, signature)) {
      note(caller, owner + "." + signature);
    }
  }

  private boolean found(String owner, String signature) {
    if (!own.containsKey(owner)) {
      return phone.has(owner, signature) || !phone.has(owner); // of a class that is not there at all it was said already
    }
    if (own.get(owner).contains(signature)) {
      return true;
    }
    for (String parent : parents.get(owner)) {
      if (parent != null && found(parent, signature)) {
        return true;
      }
    }
    return phone.has("java/lang/Object", signature);
  }

  private void note(String caller, String what) {
    missing.computeIfAbsent(caller, name -> new TreeSet<>()).add(what.replace('/', '.'));
  }
}
