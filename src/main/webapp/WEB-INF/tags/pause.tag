<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="pause.label" var="label"/>
<aside id="pause" class="pause ${empty pause ? '' : 'paused'}" data-live="pause" aria-label="${label}">
  <c:choose>
    <c:when test="${empty pause}">
      <c:if test="${caller.mayPause()}">
        <form method="post" action="${root}/fleet/pause">
          <t:csrf/>
          <input type="hidden" name="back" value="<c:out value="${address}"/>">
          <button class="danger"><fmt:message key="pause.all"/></button>
        </form>
        <small class="faint"><fmt:message key="pause.notSafety"/></small>
      </c:if>
    </c:when>
    <c:otherwise>
      <p role="status"><strong><fmt:message key="pause.paused"/></strong>${" "}<fmt:message key="pause.by"><fmt:param><bdi><c:out value="${pause.user}"/></bdi></fmt:param></fmt:message>${" "}<t:time at="${pause.since}"/>${" "}· <small><fmt:message key="pause.notSafety"/></small></p>
      <c:if test="${caller.mayOperate()}">
        <details>
          <summary role="button"><fmt:message key="pause.resume"/></summary>
          <form method="post" action="${root}/fleet/resume">
            <t:csrf/>
            <input type="hidden" name="back" value="<c:out value="${address}"/>">
            <p><fmt:message key="pause.resume.sure"/></p>
            <button><fmt:message key="pause.resume.submit"/></button>
          </form>
        </details>
      </c:if>
      <c:if test="${not caller.mayOperate()}"><small><fmt:message key="pause.askManager"/></small></c:if>
    </c:otherwise>
  </c:choose>
</aside>
