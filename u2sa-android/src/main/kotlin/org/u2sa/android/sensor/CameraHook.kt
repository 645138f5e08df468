package org.u2sa.android.sensor

import java.lang.reflect.Constructor
import java.lang.reflect.InvocationTargetException
import org.u2sa.core.launch.LaunchOptions
import org.u2sa.core.launch.SystemFile
import org.u2sa.device.Camera
import org.u2sa.device.CameraSensor
import org.u2sa.service.ServiceContext

/**
 * Gives the phone's camera to those services of a system that look through it: classes with a public constructor
 * (ServiceContext, Camera).
 */
class CameraHook(system: SystemFile) {
    private val users: List<Constructor<out CameraSensor>> = system.services().mapNotNull { constructor(it.className()) }

    /** Whether a service of the system looks: then the user is asked for the camera. */
    val isWanted: Boolean get() = users.isNotEmpty()

    /** @param open makes a camera for one service, which closes it */
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
            throw e.targetException // the service's own words: a wrong variable
        } finally {
            if (made == null) {
                camera.close()
            }
        }
    }

    /** Null: no class that looks. What is wrong with it otherwise is said when the system starts. */
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
