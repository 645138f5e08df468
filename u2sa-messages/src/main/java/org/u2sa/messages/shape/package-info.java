/**
 * Objects with an extent: shapes and point clouds, and distances to them. What objects are in
 * general is in {@code messages}.
 */
package org.u2sa.messages.shape;
