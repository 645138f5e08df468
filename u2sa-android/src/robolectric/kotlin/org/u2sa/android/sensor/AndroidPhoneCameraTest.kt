package org.u2sa.android.sensor

import android.Manifest
import android.hardware.camera2.CameraCharacteristics
import android.hardware.camera2.CameraManager
import org.assertj.core.api.Assertions.assertThat
import org.junit.After
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.Shadows.shadowOf
import org.robolectric.shadows.ShadowCameraCharacteristics
import org.u2sa.android.OnPhone
import org.u2sa.interfaces.time.SystemClock

@RunWith(RobolectricTestRunner::class)
class AndroidPhoneCameraTest {
    private val phone = OnPhone()
    private val made = mutableListOf<AndroidPhoneCamera>()

    @After
    fun close() = made.forEach(AndroidPhoneCamera::close)

    private fun camera() = AndroidPhoneCamera(phone.application, SystemClock()).also(made::add)

    private fun has(facing: Int) {
        val characteristics = ShadowCameraCharacteristics.newCameraCharacteristics()
        shadowOf(characteristics).set(CameraCharacteristics.LENS_FACING, facing)
        shadowOf(phone.application.getSystemService(CameraManager::class.java)).addCamera("$facing", characteristics)
    }

    @Test
    fun open_notAllowed_saysSo() {
        has(CameraCharacteristics.LENS_FACING_BACK)

        assertThat(camera().trouble()).contains("permission")
    }

    @Test
    fun open_onlyASelfieCamera_saysSo() {
        phone.allow(Manifest.permission.CAMERA)
        has(CameraCharacteristics.LENS_FACING_FRONT)

        assertThat(camera().trouble()).contains("no rear camera")
    }

    @Test
    fun open_allowed_waitsForPicturesAndCloses() {
        phone.allow(Manifest.permission.CAMERA)
        has(CameraCharacteristics.LENS_FACING_BACK)
        val camera = camera()

        phone.await("the camera") { camera.isConnected() }

        assertThat(camera.read(0)).isEmpty() // Robolectric takes none
        assertThat(camera.connections()).isEqualTo(1)
    }
}
