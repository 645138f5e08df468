package org.u2sa.android.sensor

import org.assertj.core.api.Assertions.assertThat
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Test
import org.u2sa.interfaces.communication.Channels
import org.u2sa.messages.contract.HealthReport
import org.u2sa.service.ServiceContext
import org.u2sa.testkit.ServiceKit

class CameraSensorTest {
    private val kit = ServiceKit()
    private val camera = TestCamera()
    private lateinit var eye: Eye

    /** Remembers what it saw. */
    class Eye(context: ServiceContext, camera: PhoneCamera) : CameraSensor(context, "Eye", camera) {
        val seen = mutableListOf<PhoneCamera.Picture>()

        override fun look(picture: PhoneCamera.Picture) {
            seen += picture
        }
    }

    @AfterEach
    fun close() = kit.close()

    private fun start() = kit.start { context -> Eye(context, camera).also { eye = it } }

    private fun picture() = PhoneCamera.Picture(0, 1, 1, byteArrayOf(7))

    @Test
    fun step_eachPicture_isLookedAtOnce() {
        start()
        val first = picture()
        val second = picture()
        camera.picture = first
        kit.advance(0.5)
        camera.picture = second
        kit.advance(0.5)

        assertThat(eye.seen).containsExactly(first, second)
    }

    @Test
    fun step_cameraTaken_isSaidInHealth() {
        start()
        camera.trouble = "another application took the camera"
        kit.advance(2.0)

        assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError)).hasValue("another application took the camera")
    }

    @Test
    fun kill_running_closesTheCamera() {
        start()
        eye.kill()
        kit.settle()
        eye.join(30_000)

        assertThat(camera.isClosed).isTrue()
    }
}
