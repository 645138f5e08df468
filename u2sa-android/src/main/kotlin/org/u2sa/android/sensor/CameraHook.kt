package org.u2sa.android.sensor

import java.lang.reflect.Constructor
import java.lang.reflect.InvocationTargetException
import org.u2sa.core.launch.LaunchOptions
import org.u2sa.core.launch.SystemFile
import org.u2sa.device.port.Camera
import org.u2sa.device.CameraSensor
import org.u2sa.service.ServiceContext

/**
 * Injects the phone's camera into services that use one: classes with a public constructor (ServiceContext, Camera).
 */
class CameraHook(system: SystemFile) {
    private val users: List<Constructor<out CameraSensor>> = system.services().mapNotNull { constructor(it.className()) }

    /** Whether a service of the system uses a camera; if so, the permission is requested. */
    val isWanted: Boolean get() = users.isNotEmpty()

    /** @param open opens a camera for one service, which closes it */
    fun configure(options: LaunchOptions, open: () -> Camera) = users.forEach { give(options, it, open) }

    private fun <S : CameraSensor> give(options: LaunchOptions, user: Constructor<S>, open: () -> Camera) {
        options.making(user.declaringClass) { context -> make(user, context, open()) }
    }

    private fun <S : CameraSensor> make(user: Constructor<S>, context: ServiceContext, camera: Camera): S {
        var made: S? = null
        try {
            made = user.newInstance(context, camera)
            return made
        } catch (e: InvocationTargetException) {
            throw e.targetException // the service's own error, such as an invalid variable
        } finally {
            if (made == null) {
                camera.close()
            }
        }
    }

    /** Null if the class uses no camera. Other faults of the class are reported at system start. */
    private fun constructor(className: String): Constructor<out CameraSensor>? = try {
        Class.forName(className, false, CameraHook::class.java.classLoader)
            .takeIf { CameraSensor::class.java.isAssignableFrom(it) }
            ?.asSubclass(CameraSensor::class.java)
            ?.getConstructor(ServiceContext::class.java, Camera::class.java)
    } catch (e: ClassNotFoundException) {
        null
    } catch (e: NoSuchMethodException) {
        null
    } catch (e: LinkageError) {
        null
    }
}
