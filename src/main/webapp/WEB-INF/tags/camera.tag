<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" description="what a camera sees now; shared/cameras.js fetches it" %>
<%@ attribute name="camera" required="true" type="org.toqa.camera.Camera" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<fmt:message key="camera.picture" var="label"><fmt:param value="${camera.name()}"/></fmt:message>
<figure class="camera" data-camera="${camera.id()}" data-floor="<c:out value="${camera.floor()}"/>">
  <img alt="<c:out value="${label}"/>" width="640" height="480" hidden>
  <p class="notice" role="status" hidden></p>
  <figcaption><bdi><c:out value="${camera.name()}"/></bdi></figcaption>
</figure>
