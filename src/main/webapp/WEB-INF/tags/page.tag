<%@ tag body-content="scriptless" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="title" required="true" description="already in the user's language; escaped here" %>
<%@ attribute name="here" description="the entry of the navigation that is shown" %>
<%@ attribute name="script" description="a module of assets/js" %>
<%@ attribute name="layout" description="a class of the main part" %>
<%@ attribute name="urgent" fragment="true" description="what the page has to say above all, more urgent than anything else" %>
<%@ attribute name="remark" fragment="true" description="likewise, less urgent" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<!DOCTYPE html>
<html lang="${language}" dir="${direction}">
<head>
  <meta charset="utf-8">
  <meta name="viewport" content="width=device-width, initial-scale=1">
  <meta name="color-scheme" content="light dark">
  <title><c:out value="${title}"/> · <fmt:message key="product.name"/></title>
  <link rel="icon" type="image/svg+xml" href="${root}/assets/toqa.svg">
  <link rel="stylesheet" href="${root}/assets/pico/pico.blue.min.css">
  <c:forTokens items="base,layout,pages,tables,timeline,users,statistics,laboratory,exploration,new-task,map,small-screens,editor,api,help,control,cameras,notices" delims="," var="part"><link rel="stylesheet" href="${root}/assets/css/${part}.css"></c:forTokens>
  <c:if test="${not empty script or not empty caller}"><script type="module" src="${root}/assets/js/${empty script ? 'shared/live.js' : script}"></script></c:if>
  <c:if test="${not empty caller}"><script type="module" src="${root}/assets/js/notices/bell.js"></script></c:if>
  <script type="module" src="${root}/assets/js/shared/times.js"></script>
  <c:if test="${not empty caller}"><script type="module" src="${root}/assets/js/shared/menu.js"></script><script type="module" src="${root}/assets/js/shared/unsent.js"></script><script type="module" src="${root}/assets/js/shared/banners.js"></script></c:if>
  <c:if test="${not empty errors}"><script type="module" src="${root}/assets/js/shared/first-fault.js"></script></c:if>
  <c:if test="${pageContext.request.queryString.contains('done=')}"><script type="module" src="${root}/assets/js/shared/told-once.js"></script></c:if>
</head>
<body>
  <a class="skip" href="#content"><fmt:message key="nav.skip"/></a>
  <header class="top">
    <a class="brand" href="${root}/"><img src="${root}/assets/toqa.svg" alt="" width="28" height="28"><span><fmt:message key="product.name"/></span></a>
    <c:if test="${not empty caller}">
      <fmt:message key="nav.label" var="label"/>
      <nav aria-label="${label}">
        <c:forTokens items="task,robot,map,floor,user,statistics" delims="," var="entry">
          <c:set var="target" value="${entry == 'map' or entry == 'statistics' ? entry : (entry += 's')}"/>
          <a ${entry == 'floor' or entry == 'statistics' ? 'class="desk"' : ''} href="${root}/${target}" ${here == entry ? 'aria-current="page"' : ''}><t:icon name="${entry}"/><span><fmt:message key="nav.${entry}"/></span></a>
        </c:forTokens>
        <details class="more">
          <summary><t:icon name="more"/><span><fmt:message key="nav.more"/></span></summary>
          <ul>
            <c:forTokens items="floor,statistics" delims="," var="entry">
              <li class="phone"><a href="${root}/${entry == 'floor' ? 'floors' : entry}" ${here == entry ? 'aria-current="page"' : ''}><fmt:message key="nav.${entry}"/></a></li>
            </c:forTokens>
            <c:set var="further" value="history,templates,schedules,loads,cameras,network${caller.mayOrder() ? ',import' : ''}${caller.isAdministrator() ? ',sites' : ''}${caller.isManager() ? ',laboratory,settings' : ''},api,help"/>
            <c:forTokens items="${further}" delims="," var="entry">
              <li><a href="${root}/${entry == 'import' ? 'tasks/import' : entry}" ${here == entry ? 'aria-current="page"' : ''}><fmt:message key="nav.${entry}"/></a></li>
            </c:forTokens>
          </ul>
        </details>
        <form method="post" action="${root}/logout">
          <t:csrf/>
          <button><t:icon name="logout"/><span><fmt:message key="nav.logout"/></span></button>
        </form>
      </nav>
      <fmt:message key="notices.title" var="bell"/>
      <a class="bell" href="${root}/notices" ${here == 'notice' ? 'aria-current="page"' : ''} aria-label="${bell}" title="${bell}" data-unseen="<fmt:message key="notices.bell"/>"><t:icon name="bell"/><span class="count" hidden></span></a>
    </c:if>
    <c:forEach items="${languages}" var="other">
      <c:if test="${other.tag() != language}">
        <c:url value="/language/${other.tag()}" var="target"><c:param name="back" value="${address}"/></c:url>
        <a class="language" lang="${other.tag()}" hreflang="${other.tag()}" rel="nofollow" href="<c:out value="${target}"/>"><fmt:message key="language.${other.tag()}"/></a>
      </c:if>
    </c:forEach>
  </header>
  <c:if test="${not empty visitedSite}">
    <aside class="notice visit">
      <span><fmt:message key="sites.looking"><fmt:param><bdi><c:out value="${visitedSite}"/></bdi></fmt:param></fmt:message></span>
      <c:url value="/sites/${caller.site().name()}/visit" var="home"/>
      <form method="post" action="<c:out value="${home}"/>"><t:csrf/><button class="outline"><fmt:message key="sites.back"/></button></form>
    </aside>
  </c:if>
  <c:if test="${not empty caller}">
    <t:pause/>
    <div id="banners">
    <jsp:invoke fragment="urgent"/>
    <c:url value="/" var="login"><c:param name="next" value="${address}"/></c:url>
    <p id="offline" class="notice bad" role="alert" hidden><span data-connection="unsent"><fmt:message key="page.unsent"/></span><span data-connection="disconnected"><fmt:message key="map.disconnected"/></span><span data-connection="loggedOut"><fmt:message key="map.loggedOut"/>${" "}<a href="<c:out value="${login}"/>"><fmt:message key="map.loggedOut.link"/></a></span></p>
    <div id="alerts" role="alert"><c:forEach items="${alerts}" var="alert"><p class="notice bad"><t:said sentence="${alert}"/></p></c:forEach></div>
    <jsp:invoke fragment="remark"/>
    </div>
    <button type="button" id="more-banners" class="outline secondary" aria-controls="banners" data-more="<fmt:message key="banners.more"/>" data-less="<fmt:message key="banners.less"/>" hidden></button>
  </c:if>
  <main id="content" class="${layout}">
    <jsp:doBody/>
  </main>
</body>
</html>
